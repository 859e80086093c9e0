// Roughness 1e-30 seen exactly along its highlight: one pixel is brighter than single precision holds, and white.
#version 3.7;
#declare Roughness = 1e-30;
#include "aligned.inc"
