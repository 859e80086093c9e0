// Specular (Blinn) highlights: roughness from sharp to broad, albedo, metallic, together with phong.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <5, 6, -6>, rgb <1, 0.95, 0.8> }
light_source { <-6, 4, -3>, rgb <0.2, 0.3, 0.6> }
sphere { <-2.1, 1, 0>, 0.85 pigment { rgb <0.7, 0.2, 0.2> } finish { specular 0.9 } }
sphere { <0, 1, 0>, 0.85 pigment { rgb <0.2, 0.6, 0.3> } finish { specular 0.7 roughness 0.2 } }
sphere { <2.1, 1, 0>, 0.85 pigment { rgb <0.3, 0.3, 0.8> } finish { specular 1 roughness 0.004 } }
sphere { <-2.1, -1, 0>, 0.85 pigment { rgb <0.8, 0.6, 0.2> } finish { specular 0.9 roughness 0.05 metallic } }
sphere { <0, -1, 0>, 0.85 pigment { rgb <0.8, 0.6, 0.2> } finish { specular 0.4 roughness 0.02 phong 0.3 phong_size 10 metallic 0.5 } }
sphere { <2.1, -1, 0>, 0.85 pigment { rgb <0.6, 0.6, 0.6> } finish { specular albedo 0.15 roughness 0.1 } }
