// conserve_energy takes from the transmitted light what is reflected; left without, right with.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }

#declare Shiny = finish { ambient 0.1 diffuse 0.3 reflection { 0.1, 0.8 } }
sphere { <-1.4, 0, 0>, 1.2 pigment { rgbf <0.9, 0.8, 0.6, 0.7> } finish { Shiny } }
sphere { <1.4, 0, 0>, 1.2 pigment { rgbf <0.9, 0.8, 0.6, 0.7> } finish { Shiny conserve_energy } }
