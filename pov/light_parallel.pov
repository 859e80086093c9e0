// A parallel light: one direction everywhere, shadows of equal size; what lies behind the plane of the light casts none.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <4, 5, -3>, rgb 0.9 parallel point_at <0, 0, 0> }
sphere { <7, 10, -5>, 1.5 pigment { rgb 1 } }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }

sphere { <-1.5, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 specular 0.4 } }
box { <0.5, -1, -0.7>, <1.9, 0.5, 0.7> rotate 25*y pigment { rgb <0.9, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.7 } }
