// filter tints what is behind, transmit does not, both together, and more than the whole (filter 1.2); the shadows are tinted alike.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <4, 7, -4>, rgb 1 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -1.2 pigment { checker rgb 0.9 rgb 0.6 } }
sphere { <-2.3, 0, 0>, 0.9 pigment { rgbf <0.9, 0.3, 0.2, 0.8> } }
sphere { <-0.3, 0, 0>, 0.9 pigment { rgbt <0.2, 0.8, 0.3, 0.7> } }
box { -0.7, 0.7 rotate <0, 30, 0> translate <1.8, -0.4, -0.5> pigment { rgbft <0.3, 0.4, 0.9, 0.5, 0.3> } finish { phong 0.6 } }
disc { <2.4, 0.5, 1.5>, <-0.3, 0.3, -1>, 0.9 pigment { rgbf <0.9, 0.9, 0.2, 1.2> } }
