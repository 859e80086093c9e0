// Spheres, ellipsoids by scaling, a sheared sphere by a matrix, one within another and one around the camera.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

sphere { <-2, 0, 0>, 0.9 pigment { rgb <0.9, 0.3, 0.3> } }
sphere { 0, 1 scale <0.4, 1, 0.4> rotate 30*z pigment { rgb <0.3, 0.8, 0.3> } finish { phong 0.5 } }
sphere { 0, 0.8 matrix <1, 0.3, 0, -0.2, 0.9, 0.1, 0, 0.2, 1.1, 2, 0, 0> pigment { rgb <0.3, 0.4, 0.9> } }
sphere { <0, 0, 0>, 50 pigment { rgb 1 transmit 0.9 } finish { ambient 0.5 diffuse 0 } no_shadow }
