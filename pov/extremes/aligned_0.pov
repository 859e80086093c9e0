// Roughness 0 seen exactly along its highlight: there is no highlight at all.
#version 3.7;
#declare Roughness = 0;
#include "aligned.inc"
