// Cylinder lights: parallel rays inside a tube with a soft wall.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <-4, 5, -4>, rgb <1, 0.7, 0.3> cylinder point_at <-1.2, -0.5, 0> radius 0.8 falloff 1.3 tightness 0 }
light_source { <4, 6, -3>, rgb <0.4, 0.6, 1> cylinder point_at <1.5, 0, 0> radius 0.5 falloff 1.6 tightness 1 }
light_source { <0, 8, -8>, rgb 0.15 shadowless }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }

sphere { <-1.5, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 specular 0.4 } }
box { <0.5, -1, -0.7>, <1.9, 0.5, 0.7> rotate 25*y pigment { rgb <0.9, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.7 } }
