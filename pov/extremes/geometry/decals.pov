// A box, two triangles and a plane that lie in one plane: the first in the file is seen, and none shadows another.
#version 3.7;
#declare Levels = 4;
#include "finishes.inc"
background { rgb <0.3, 0.5, 0.8> }
camera { location <0.1, 3, -3> direction 1.6*z right 4/3*x up y look_at <0, 0.3, 0.1> }
light_source { <-2, 4, -1>, 0.9 }
mesh {
    triangle { <-1.4, 0.3, -0.9>, <-0.2, 0.3, -0.8>, <-0.3, 0.3, 0.6> }
    triangle { <-1.4, 0.3, -0.9>, <-0.3, 0.3, 0.6>, <-1.5, 0.3, -0.1> }
    pigment { Green }
    finish { Matte }
}
box { <-1.2, -0.7, -0.5>, <1.2, 0.3, 0.9> pigment { Red } finish { Matte } }
plane { y, 0.3 pigment { White } finish { Matte } }
box { <0.6, -0.7, -0.9>, <1.5, 0.3, 0.3> pigment { Blue } finish { Matte } }
