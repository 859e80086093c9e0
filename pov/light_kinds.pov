// spotlight, cylinder and shadowless are kinds of one light, of which the last one stated holds; only the parallel rays of a cylinder light stay.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <-4, 6, -3>, rgb <0.6, 0.3, 0.3> spotlight point_at <-1.5, 0, 0> radius 9 falloff 16 shadowless }
light_source { <3, 6, -4>, rgb <0.3, 0.8, 0.3> shadowless spotlight point_at <1, -1, 0> radius 12 falloff 25 }
light_source { <0, 5, -4>, rgb <0.3, 0.3, 0.7> cylinder point_at <0, -1, 0> radius 2 falloff 3 shadowless }
light_source { <5, 5, 4>, rgb <0.5, 0.4, 0.2> spotlight cylinder point_at <0, -1, 0> radius 2 falloff 3 }
light_source { <-5, 5, 4>, rgb <0.2, 0.1, 0.2> cylinder spotlight point_at <0, -1, 0> radius 5 falloff 9 }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }
sphere { <-1.5, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 specular 0.4 } }
box { <0.5, -1, -0.7>, <1.9, 0.5, 0.7> rotate 25*y pigment { rgb <0.9, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.7 phong 0.5 } }
