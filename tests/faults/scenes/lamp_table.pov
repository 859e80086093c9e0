// A table under a spot, a point lamp and an area lamp; a torus, a checkered top; POV-Ray's profile.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
background { rgb <0.15, 0.2, 0.35> }
camera { location <-3, 4, -7> look_at <0, 0.3, 0> angle 42 }
light_source { <4, 7, -4>, rgb <0.8, 0.7, 0.5> }
light_source { <-5, 6, -1>, rgb <0.3, 0.4, 0.9> spotlight point_at <0, 0, 0> radius 12 falloff 25 }
light_source { <0, 5, -6>, rgb 0.35 area_light <1.5, 0, 0>, <0, 1.5, 0>, 2, 2 }
box { <-3, -0.2, -2.5>, <3, 0, 2.5> pigment { checker rgb <0.8, 0.7, 0.6>, rgb <0.3, 0.25, 0.4> scale 0.7 }
  finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.08 reflection 0.15 } rotate 14*y }
torus { 0.9, 0.3 pigment { rgb <0.8, 0.4, 0.1> } finish { ambient 0.1 diffuse 0.6 specular 0.6 roughness 0.1 }
  rotate <60, 0, 20> scale <1, 0.7, 1.2> translate <-1, 0.9, 0> }
sphere { 0, 0.7 pigment { rgb <0.4, 0.7, 0.8> } finish { ambient 0.05 diffuse 0.5 phong 0.7 phong_size 30 reflection { 0.1, 0.6 } }
  scale <1.2, 1, 0.6> rotate 30*y translate <1.3, 0.7, -0.8> }
