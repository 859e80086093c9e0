// Phong highlights: sizes, albedo, metallic tint, and on a coloured light.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <5, 6, -6>, rgb <1, 0.95, 0.8> }
light_source { <-6, 4, -3>, rgb <0.2, 0.3, 0.6> }
sphere { <-2.1, 1, 0>, 0.85 pigment { rgb <0.7, 0.2, 0.2> } finish { phong 0.9 } }
sphere { <0, 1, 0>, 0.85 pigment { rgb <0.2, 0.6, 0.3> } finish { phong 0.7 phong_size 8 } }
sphere { <2.1, 1, 0>, 0.85 pigment { rgb <0.3, 0.3, 0.8> } finish { phong 1 phong_size 150 } }
sphere { <-2.1, -1, 0>, 0.85 pigment { rgb <0.8, 0.6, 0.2> } finish { phong 0.9 phong_size 20 metallic } }
sphere { <0, -1, 0>, 0.85 pigment { rgb <0.8, 0.6, 0.2> } finish { phong 0.9 phong_size 20 metallic 0.4 } }
sphere { <2.1, -1, 0>, 0.85 pigment { rgb <0.6, 0.6, 0.6> } finish { phong albedo 0.2 phong_size 5 } }
