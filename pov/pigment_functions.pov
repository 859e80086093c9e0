// Functions that ask a pigment and a pattern, averages with and without weights, tiles, and a pigment that takes away what lies behind.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 0.2, 0> right x*4/3 angle 45 }
light_source { <4, 8, -6> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
#declare Colour = function { pigment { wood turbulence 0.2 color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgbt <0.2, 0.5, 0.8, 0.5>] } scale 0.6 } }
#declare Waves = function { pattern { radial frequency 6 sine_wave rotate 20*x } }
plane { y, -1 texture { tiles { texture { pigment { rgb 0.9 } } tile2 texture { pigment { rgb <0.3, 0.2, 0.2> } } } } }
sphere { <-2.2, 0, 0>, 1
    pigment { average pigment_map {
        [function { pow(Colour(x, y, z).red, 1.5) } color_map { [0 rgb 0] [1 rgb <3, 0, 0>] }]
        [function { Colour(x, y, z).gray } color_map { [0 rgb 0] [1 rgb <0, 3, 0>] }]
        [function { Colour(x, y, z).transmit } color_map { [0 rgb 0] [1 rgb <0, 0, 3>] }] } } }
sphere { 0, 1 pigment { function { Waves(x, y, z) * (1 - y) } color_map { [0 rgb <0.2, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.5>] } } }
sphere { <2.2, 0, 0>, 1 pigment { rgb 0.7 } normal { average normal_map { [3 bumps 0.6 scale 0.3] [ripples 1 scale 0.2] } } }
box { <0.7, -1, -2>, <1.9, -0.2, -1.99> pigment { rgb 0.5 transmit -0.5 } finish { ambient 0.6 diffuse 0 } }
