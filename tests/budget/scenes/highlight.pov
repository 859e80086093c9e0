// The plain scene, with a highlight on each sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
sphere { <-1.5, 0, 0>, 0.9 pigment { rgb <0.9, 0.3, 0.3> } finish { specular 0.6 roughness 0.3 } }
sphere { <1.2, 0.2, 0.4>, 1.1 pigment { rgb <0.3, 0.8, 0.3> } finish { specular 0.6 roughness 0.3 } }
sphere { <0, -0.8, -1.5>, 0.4 pigment { rgb <0.3, 0.4, 0.9> } finish { specular 0.6 roughness 0.3 } }
