// Lights that fade with distance: up to twice as bright nearer than fade_distance; two colours overlap; a negative light darkens.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <-3, 2, -2>, rgb <1, 0.5, 0.2> fade_distance 2.5 fade_power 2 }
light_source { <3, 3, -1>, rgb <0.3, 0.5, 1> fade_distance 3 fade_power 3 }
light_source { <0, 4, 3>, rgb -0.15 fade_distance 4 fade_power 1 }
plane { y, -1 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.8 } }

sphere { <-1.5, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0.05 diffuse 0.7 specular 0.4 } }
box { <0.5, -1, -0.7>, <1.9, 0.5, 0.7> rotate 25*y pigment { rgb <0.9, 0.8, 0.7> } finish { ambient 0.05 diffuse 0.7 } }
