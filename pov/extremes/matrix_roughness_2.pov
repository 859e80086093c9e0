// Roughness 2 for all pairs of terms: lobes wider than the hemisphere.
#version 3.7;
#declare Roughness = 2;
#include "matrix.inc"
