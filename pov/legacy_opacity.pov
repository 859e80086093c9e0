// Language 3.6: the opacity of a surface is 1 - (filter max(rgb) + transmit), not 1 - filter - transmit; the file asks for linear light all the same.
#version 3.6;

global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }

sphere { <-1.4, 0, 0>, 1.2 pigment { rgbf <0.4, 0.5, 0.3, 0.9> } finish { ambient 0.3 diffuse 0.6 } }
sphere { <1.4, 0, 0>, 1.2 pigment { rgbft <0.9, 0.2, 0.3, 0.5, 0.3> } finish { ambient 0.3 diffuse 0.6 } }
