// Light and view at cosines about 1e-4, ggx with ggx-hc.
#version 3.7;
//! raytrace: D=ggx G=ggx-hc
#declare Height = 1e-4;
#declare Roughness = 0.5;
#declare Weight = 0.15;
#declare Width = 6*Height;
#declare Lamp = 1;
#include "graze.inc"
