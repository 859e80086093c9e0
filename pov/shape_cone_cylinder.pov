// Cones and cylinders, closed and open, with an apex, upside down and lying.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

cone { <-2.4, -1, 0>, 0.8, <-2.4, 1, 0>, 0 pigment { rgb <0.9, 0.4, 0.3> } }
cone { <-0.8, -1, 0>, 0.3, <-0.8, 0.6, 0.2>, 0.8 open pigment { rgb <0.9, 0.8, 0.3> } }
cylinder { <0.4, -0.6, -1.2>, <1.4, -0.6, -1.6>, 0.4 pigment { rgb <0.3, 0.8, 0.5> } finish { phong 0.7 } }
cylinder { <2.2, -1, 0.4>, <2.4, 0.8, 0>, 0.7 open pigment { rgb <0.4, 0.5, 0.9> } }
cylinder { <0.8, -1, 1.5>, <0.8, 1.2, 1.5>, 0.5 pigment { rgb 0.7 } scale <1.4, 1, 1> }
