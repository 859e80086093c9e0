// Light and view at cosines about 1e-4, ggx with ggx.
#version 3.7;
//! raytrace: D=ggx G=ggx
#declare Height = 1e-4;
#declare Roughness = 0.5;
#declare Weight = 1;
#declare Width = 6*Height;
#declare Lamp = 100;
#include "graze.inc"
