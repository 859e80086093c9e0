// no_shadow, no_image, no_reflection, double_illuminate and inverse over a mirror.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

background { rgb <0.5, 0.65, 0.9> }
plane { y, -1.2 pigment { rgb <0.3, 0.3, 0.35> } finish { reflection 0.5 } }
sphere { <-2.4, 0, 0>, 0.8 pigment { rgb <0.9, 0.3, 0.2> } no_shadow }
sphere { <-0.6, 0, 0>, 0.8 pigment { rgb <0.3, 0.9, 0.3> } no_image }
sphere { <1.2, 0, 0>, 0.8 pigment { rgb <0.3, 0.4, 0.9> } no_reflection }
disc { <2.8, 0.2, 0.5>, <-0.6, 0.3, -1>, 0.9 pigment { rgb <0.9, 0.8, 0.2> } double_illuminate }
disc { <0, 1.8, 1.5>, <0, -1, 0.4>, 0.6 pigment { rgb <0.9, 0.5, 0.8> } inverse }
