// A circular area light that turns towards each point, and area_illumination with every grid point shining by itself.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <4, 6, -4>, rgb 0.6 area_light <2, 0, 0>, <0, 2, 0>, 4, 4 adaptive 0 circular orient }
light_source { <-4, 3, -2>, rgb <0.3, 0.4, 0.6> area_light <2, 0, 0>, <0, 0, 2>, 3, 3 area_illumination on fade_distance 4 fade_power 2 }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }

sphere { <-1.5, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 specular 0.4 } }
box { <0.5, -1, -0.7>, <1.9, 0.5, 0.7> rotate 25*y pigment { rgb <0.9, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.7 } }
