// The lobe of ggx at roughness 1e-4, alpha = 1e-8.
#version 3.7;
//! raytrace: D=ggx G=ggx
#declare Roughness = 1e-4;
#include "lobe.inc"
