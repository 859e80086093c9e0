// ambient against the scene's ambient_light, emission without it, diffuse with brilliance, albedo, and light from behind (back-side diffuse).
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <1.5, 1, 0.5> }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <5, 6, -6>, rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
sphere { <-2.1, 1, 0>, 0.85 pigment { rgb <0.9, 0.5, 0.3> } finish { ambient rgb <0.3, 0.1, 0.2> diffuse 0.4 } }
sphere { <0, 1, 0>, 0.85 pigment { rgb <0.5, 0.8, 0.4> } finish { ambient 0 emission rgb <0.1, 0.2, 0.4> diffuse 0.5 } }
sphere { <2.1, 1, 0>, 0.85 pigment { rgb <0.8, 0.8, 0.5> } finish { ambient 0.1 diffuse 0.9 brilliance 4 } }
sphere { <-2.1, -1, 0>, 0.85 pigment { rgb <0.5, 0.6, 0.9> } finish { ambient 0 diffuse albedo 0.5 brilliance 3 } }
sphere { <2.1, -1, 0>, 0.85 pigment { rgb <0.9, 0.9, 0.9> } finish { ambient 0.5 diffuse 0 } }

triangle { <-0.9, -1.8, 0>, <0.9, -1.8, 0>, <0, -0.1, 0> rotate 150*y pigment { rgb <0.9, 0.7, 0.2> } finish { ambient 0 diffuse 0.2, 0.7 } }
