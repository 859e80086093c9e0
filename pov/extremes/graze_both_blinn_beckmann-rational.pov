// Light and view at cosines about 1e-4, blinn with beckmann-rational.
#version 3.7;
//! raytrace: D=blinn G=beckmann-rational
#declare Height = 1e-4;
#declare Roughness = 0.5;
#declare Weight = 1;
#declare Width = 6*Height;
#declare Lamp = 40;
#include "graze.inc"
