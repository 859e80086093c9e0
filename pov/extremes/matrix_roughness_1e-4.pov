// Roughness 1e-4 for all pairs of terms: lobes of 1e-8 radians.
#version 3.7;
#declare Roughness = 1e-4;
#include "matrix.inc"
