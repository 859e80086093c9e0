// Roughness 0 for all pairs of terms: no width: a highlight that only the mirror ray could carry.
#version 3.7;
#declare Roughness = 0;
#include "matrix.inc"
