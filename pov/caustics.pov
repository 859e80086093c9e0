// Caustics of the interior brighten the middle of the shadow of clear bodies.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <3, 7, -2>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.2 pigment { rgb 0.7 } }
sphere { <-1.5, 0, 0>, 0.9 pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { ambient 0 diffuse 0.1 phong 0.7 } interior { ior 1.4 caustics 1 } }
sphere { <1.5, 0, 0>, 0.9 pigment { rgbf <1, 0.7, 0.4, 0.9> } finish { ambient 0 diffuse 0.1 phong 0.7 } interior { caustics 0.15 } }
