// Bodies at the origin, each moved to 1e8 from it by its transform.
#version 3.7;
#declare Levels = 6;
#include "finishes.inc"
#declare Place = 1e8*<1, 0.6, -0.8>;
background { rgb <0.3, 0.5, 0.8> }
camera { location Place + <0, 1.5, -5> direction 1.5*z right 4/3*x up y look_at Place }
light_source { Place + <-4, 7, -5>, 0.9 }
plane { y, -0.5 pigment { White } finish { Matte } translate Place }
sphere { 0, 0.5 pigment { Red } finish { Matte } translate <-1.5, 0, 0> translate Place }
box { -0.5, 0.5 pigment { Green } finish { Matte } translate <-0.2, 0, 1> translate Place }
cylinder { <0, -0.5, 0>, <0.3, 0.9, 0.2>, 0.3 pigment { Blue } finish { Matte } translate <0.9, 0, 1> translate Place }
mesh {
    triangle { <0, 0.4, 0>, <-0.5, -0.5, -0.3>, <0.5, -0.5, -0.3> }
    triangle { <0, 0.4, 0>, <0.5, -0.5, -0.3>, <0, -0.5, 0.6> }
    triangle { <0, 0.4, 0>, <0, -0.5, 0.6>, <-0.5, -0.5, -0.3> }
    pigment { Gold }
    finish { Matte }
    translate <-0.4, 0, -1.2>
    translate Place
}
sphere { 0, 0.5 pigment { Gold } finish { Polished } translate <1.7, 0, 0> translate Place }
sphere { 0, 0.4 pigment { rgb 1 transmit 1 } finish { Clear } interior { ior 1.5 } no_shadow translate <0.6, 0, -0.9> translate Place }
