// No camera statement: location 0, direction z and the right vector <1.33, 0, 0> with its three digits.
#version 3.7;
global_settings { assumed_gamma 1 }

light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

sphere { <-1, 0, 5>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <1.2, -0.4, 4>, 0.6 pigment { rgb <0.2, 0.5, 0.9> } }
