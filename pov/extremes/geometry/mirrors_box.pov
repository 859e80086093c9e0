// A box whose six walls are mirrors, seen from within, and 256 levels of rays.
#version 3.7;
#declare Levels = 256;
#include "finishes.inc"
camera { location <0.31, 0.13, -0.72> direction 0.9*z right 4/3*x up y look_at <0.1, -0.05, 0.6> }
light_source { <0.2, 0.7, -0.3>, 0.5 }
#declare Mirror = finish { ambient 0.004 diffuse 0 reflection { 0.985 } }
box { <-1, -0.8, -1.1>, <1, 0.9, 1.2> pigment { White } finish { Mirror } }
box { <-0.6, -0.5, 0.1>, <-0.2, 0.2, 0.5> pigment { Red } finish { Matte } }
box { <0.2, -0.6, 0.5>, <0.7, -0.1, 0.8> pigment { Blue } finish { Matte } }
