// Roughness 1e-8 taken as alpha itself, with Beckmann's distribution and Smith's masking.
#version 3.7;
//! raytrace: D=beckmann G=beckmann alpha=direct
#declare Roughness = 1e-8;
#include "lobe.inc"
