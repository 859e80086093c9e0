// Triangles and smooth triangles with interpolated normals, seen from both sides.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

triangle { <-3, -1, 0.5>, <-1.4, -1, -0.3>, <-2.2, 1, 0.2> pigment { rgb <0.9, 0.4, 0.3> } }
smooth_triangle { <-0.9, -0.9, 0>, <-0.8, 0, -1>, <0.9, -0.9, 0>, <0.8, 0, -1>, <0, 0.9, 0>, <0, 0.9, -1> pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.8 } }
smooth_triangle { <1.4, -1, 0>, <0.6, 0, 1>, <3, -1, 0>, <-0.6, 0, 1>, <2.2, 1, 0.4>, <0, -0.8, 1> pigment { rgb <0.4, 0.5, 0.9> } finish { specular 0.6 } }
