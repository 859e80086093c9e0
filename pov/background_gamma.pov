// assumed_gamma 2.2: colours are in the working space, srgb colours are converted into it, and the file gets linear light.
#version 3.7;
global_settings { assumed_gamma 2.2 }

camera { location <0, 1.2, -5> look_at 0 right x*4/3 angle 45 }
background { rgb <0.4, 0.5, 0.7> transmit 0.2 }
light_source { <3, 5, -5>, rgb 0.9 }
sphere { <-1, 0, 0>, 0.9 pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.5 } }
sphere { <1, 0, 0>, 0.9 pigment { srgb <0.8, 0.5, 0.3> } finish { phong 0.5 } }
