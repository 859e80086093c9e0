// Roughness 1e-8 for all pairs of terms: lobes of 1e-16 radians.
#version 3.7;
#declare Roughness = 1e-8;
#include "matrix.inc"
