// The lobe of beckmann at roughness 1e-4, alpha = 1e-8.
#version 3.7;
//! raytrace: D=beckmann G=cook-torrance
#declare Roughness = 1e-4;
#include "lobe.inc"
