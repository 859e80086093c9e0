// Area lights that are spotlights, cylinder lights and parallel lights at the same time; lights moved by transforms.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <0, 0, 0>, rgb <1, 0.8, 0.6> spotlight point_at <0, -6, 3> radius 14 falloff 22 area_light x, z, 3, 3 adaptive 1 translate <-1.5, 6, -3> }
light_source { <3, 5, -3>, rgb <0.4, 0.5, 0.8> parallel point_at <0.5, 0, 0> area_light 1.5*x, 1.5*z, 3, 3 }
light_source { <1, 6, 0>, rgb <0.3, 0.5, 0.2> cylinder point_at <1, 0, 0> radius 1.2 falloff 1.8 area_light 0.5*x, 0.5*z, 2, 2 rotate 20*z }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }

sphere { <-1.5, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 specular 0.4 } }
box { <0.5, -1, -0.7>, <1.9, 0.5, 0.7> rotate 25*y pigment { rgb <0.9, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.7 } }
