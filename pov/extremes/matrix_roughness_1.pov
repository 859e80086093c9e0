// Roughness 1 for all pairs of terms: the widest lobes of the usual range.
#version 3.7;
#declare Roughness = 1;
#include "matrix.inc"
