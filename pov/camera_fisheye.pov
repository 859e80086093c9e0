// A fisheye lens: a circle of rays up to 100 degrees off the view, nothing outside it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye angle 200 location <0, 1, 0> look_at <1, 1.3, 2> right 4/3*x rotate 5*z }
light_source { <2, 8, -3> rgb 1 }
plane { y, 0 pigment { checker rgb 1, rgb <0.2, 0.3, 0.6> } }
cylinder { <2, 0, 3>, <2, 4, 3>, 0.5 pigment { rgb <0.8, 0.5, 0.2> } }
sphere { <-2, 1, 1>, 1 pigment { rgb <0.7, 0.2, 0.2> } finish { phong 0.6 } }
background { rgb <0.4, 0.6, 0.9> }
