// Attenuation inside bodies: fade_power below 1000 as a power law, from 1000 on exponential, coloured by fade_color; a distance alone halves the light.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <4, 7, -4>, rgb 1 }
background { rgb <0.7, 0.8, 1> }
plane { y, -1.2 pigment { checker rgb 0.9 rgb 0.5 } }
#declare Clear = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } }
sphere { <-2.4, 0, 0>, 0.8 texture { Clear } interior { fade_distance 1 fade_power 2 fade_color rgb <0.9, 0.3, 0.2> } }
sphere { <-0.7, 0, 0>, 0.8 texture { Clear } interior { ior 1.3 fade_distance 0.8 fade_power 1001 fade_color rgb <0.2, 0.8, 0.4> } }
sphere { <1, 0, 0>, 0.8 texture { Clear } interior { fade_distance 1 } }
sphere { <2.6, 0, 0>, 0.7 texture { Clear } interior { ior 1.2 fade_distance 0.5 fade_power 1000 fade_color rgb <0.3, 0.4, 0.9> caustics 0.3 } }
