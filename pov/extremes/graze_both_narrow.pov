// Light and view at cosines about 1e-4 and a lobe of alpha = 0.0004.
#version 3.7;
//! raytrace: D=beckmann G=cook-torrance
#declare Height = 1e-4;
#declare Roughness = 0.02;
#declare Weight = 2e-10;
#declare Width = 5e-7;
#declare Lamp = 1;
#include "graze.inc"
