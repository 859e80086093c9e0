// A cylinder of 240 degrees around a line: what is above or below stays as far apart as it is.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { cylinder 3 angle 240 location <0, 1, 0> look_at <1, 1, 2> right 4/3*x up 3*y }
light_source { <2, 8, -3> rgb 1 }
cylinder { <2, 0, 3>, <2, 2, 3>, 0.5 pigment { checker rgb 1, rgb <0.2, 0.3, 0.6> scale 0.4 } }
sphere { <-2, 1, 1>, 1 pigment { rgb <0.7, 0.2, 0.2> } finish { phong 0.6 } }
box { <1, 0, -3>, <3, 1, -2> pigment { rgb <0.3, 0.6, 0.3> } }
background { rgb <0.4, 0.6, 0.9> }
