// A dull knot of 4,032 triangles on a dull floor, one lamp: edges and shadows, nothing that mirrors or shines.
#version 3.7;
global_settings { assumed_gamma 1 }

#include "../knot.inc"

camera { location <0, 2.8, -8> look_at <0, 1.2, 0> right x*4/3 angle 44 }
background { rgb <0.55, 0.65, 0.8> }
light_source { <6, 9, -7>, rgb 1.1 }

#declare Dull = finish { ambient 0.12 diffuse 0.75 }
object { Knot rotate <0, 25, 10> translate <0, 1.7, 0> pigment { rgb <0.75, 0.35, 0.2> } finish { Dull } }
plane { y, -0.5 pigment { checker rgb <0.8, 0.78, 0.7> rgb <0.35, 0.4, 0.45> scale 0.8 } finish { Dull } }
plane { -z, -6 pigment { rgb <0.5, 0.6, 0.55> } finish { Dull } }
