// Roughness 1e-8 seen exactly along its highlight: one pixel is white.
#version 3.7;
#declare Roughness = 1e-8;
#include "aligned.inc"
