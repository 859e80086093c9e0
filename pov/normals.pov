// Bumps: patterns with rules of their own, by slope, through maps; in mirrors, under layers and in glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 number_of_waves 5 }

camera { location <0, 3, -8> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
background { rgb <0.5, 0.65, 0.9> }
#default { pigment { rgb <0.9, 0.7, 0.5> } finish { phong 0.5 } }
plane { y, -1.2 pigment { rgb <0.2, 0.3, 0.5> } normal { ripples 0.4 frequency 2 scale 0.5 } finish { reflection 0.5 } }
sphere { <-2.4, 0.9, 0>, 0.8 normal { bumps 0.8 scale 0.2 } }
sphere { <-0.8, 0.9, 0>, 0.8 normal { wrinkles 0.7 scale 0.4 } finish { reflection 0.4 } }
sphere { <0.8, 0.9, 0>, 0.8 normal { granite 0.3 bump_size 0.2 scale <1, 2, 1> no_bump_scale } }
sphere { <2.4, 0.9, 0>, 0.8 normal { gradient y, 0.8 sine_wave slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.3 rotate 30*z } }
sphere { <-2.4, -0.4, -1.5>, 0.7 normal { gradient x normal_map { [0.3 dents 1 scale 0.2] [0.7 waves 0.5 scale 0.3] } } }
sphere { <-0.8, -0.4, -1.5>, 0.7 normal { average normal_map { [1 leopard 0.6 scale 0.1] [2 quilted 0.8 scale 0.4] } scale 0.8 } }
sphere { <0.8, -0.4, -1.5>, 0.7 pigment { rgbt 0.9 } normal { crackle 0.5 scale 0.3 turbulence 0.2 } interior { ior 1.4 } }
sphere { <2.4, -0.4, -1.5>, 0.7
    texture { normal { checker normal { agate 0.5 scale 0.2 } normal { facets size 0.3 } scale 0.4 } }
    texture { pigment { rgbt <0, 0.3, 0.6, 0.7> } finish { reflection 0.2 } } }
