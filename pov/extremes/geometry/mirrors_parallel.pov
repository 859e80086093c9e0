// Two mirrors that face each other, and 256 levels of rays.
#version 3.7;
#declare Levels = 256;
#include "finishes.inc"
camera { location <0.4, 0.3, -1.8> direction 1.1*z right 4/3*x up y look_at <0, 0, 2> }
light_source { <0.7, 0.8, -0.5>, 0.9 }
#declare Mirror = finish { ambient 0.002 diffuse 0 reflection { 0.985 } }
plane { z, 2 pigment { White } finish { Mirror } }
plane { z, -2 pigment { White } finish { Mirror } }
plane { y, -1 pigment { White } finish { ambient 0.1 diffuse 0.6 } }
box { <-0.9, -1, 0.2>, <-0.4, 0.2, 0.6> pigment { Green } finish { Matte } }
cylinder { <0.5, -1, 0.8>, <0.6, 0.4, 0.9>, 0.2 pigment { Red } finish { Matte } }
