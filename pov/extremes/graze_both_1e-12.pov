// Light and view at cosines about 1e-12.
#version 3.7;
//! raytrace: D=ggx G=cook-torrance
#declare Height = 1e-12;
#declare Roughness = 0.5;
#declare Weight = 5e-13;
#declare Width = 6*Height;
#declare Lamp = 1;
#include "graze.inc"
