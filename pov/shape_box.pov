// Boxes with corners in either order, turned, stretched, sheared, and one as thin as a sheet.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

box { <-2.6, -1, -0.5>, <-1.4, 0.4, 0.7> pigment { rgb <0.9, 0.4, 0.2> } }
box { <0.7, 0.7, 0.7>, <-0.7, -0.7, -0.7> rotate <35, 40, 10> pigment { rgb <0.4, 0.8, 0.4> } finish { specular 0.5 } }
box { -0.6, 0.6 matrix <1, 0.3, 0, -0.4, 0.9, 0.1, 0, 0.2, 1.1, 2.1, 0, 0.3> pigment { rgb <0.4, 0.5, 0.9> } }
box { <-3, -0.95, -2>, <3, -0.95, -1.6> pigment { rgb <0.8, 0.8, 0.2> } }
