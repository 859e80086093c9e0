// Mirrors: constant, coloured, from minimum to maximum by angle with falloff, metallic, with exponent in both spellings.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }
sphere { <-2.1, 1, 0>, 0.85 pigment { rgb <0.2, 0.2, 0.2> } finish { reflection 0.6 } }
sphere { <0, 1, 0>, 0.85 pigment { rgb <0.2, 0.2, 0.2> } finish { reflection rgb <0.8, 0.5, 0.2> } }
sphere { <2.1, 1, 0>, 0.85 pigment { rgb <0.1, 0.2, 0.3> } finish { reflection { 0.05, 0.9 falloff 3 } } }
sphere { <-2.1, -1, 0>, 0.85 pigment { rgb <0.9, 0.6, 0.2> } finish { ambient 0.05 diffuse 0.2 reflection { 0.7 metallic } } }
sphere { <0, -1, 0>, 0.85 pigment { rgb <0.3, 0.3, 0.3> } finish { reflection { 0.6 exponent 2 } } }
sphere { <2.1, -1, 0>, 0.85 pigment { rgb <0.3, 0.1, 0.1> } finish { reflection 0.5 reflection_exponent 0.6 } }
