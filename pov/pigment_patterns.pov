// Patterns over colour maps: noise, turbulence, warps and waves, old entries and built-in maps.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 8*x up 6*y }
#declare Sky_Map = color_map { [0.3 rgb <0.2, 0.4, 0.8>] [0.6 rgb 0.9] [0.8 rgb <1, 0.6, 0.3>] }
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(X, Y) translate <-3 + 2 * X, 2 - 2 * Y, 0> #end
box { -1, 1 pigment { bozo color_map { Sky_Map } turbulence 0.6 octaves 4 scale 0.5 } Tile(0, 0) }
box { -1, 1 pigment { marble color_map { [0.0, 0.6 color rgb 0.9 color rgb <0.5, 0.2, 0.2>] [0.6, 1.0 color rgb <0.5, 0.2, 0.2> color rgb 0] }
    turbulence 0.8 rotate 30*z scale 0.7 } Tile(1, 0) }
box { -1, 1 pigment { granite scale 2 } Tile(2, 0) }
box { -1, 1 pigment { agate agate_turb 0.8 scale 0.6 } Tile(3, 0) }
box { -1, 1 pigment { wood turbulence 0.1 rotate <80, 10, 0> scale 0.4 } Tile(0, 1) }
box { -1, 1 pigment { crackle form <-1, 1, 0> metric 1 color_map { Sky_Map } scale 0.5 } Tile(1, 1) }
box { -1, 1 pigment { gradient x+y sine_wave frequency 3 phase 0.2 warp { repeat 0.7*x flip y } color_map { Sky_Map } } Tile(2, 1) }
box { -1, 1 pigment { hexagon rgb 1, rgb <1, 0.5, 0>, rgb 0.2 rotate 90*x scale 0.3 warp { turbulence 0.3 } } Tile(3, 1) }
box { -1, 1 pigment { brick pigment { rgb 0.7 } pigment { leopard scale 0.1 } scale 0.2 } Tile(0, 2) }
box { -1, 1 pigment { radial pigment_map { [0.3 onion scale 0.4] [0.5 spotted color_map { Sky_Map } scale 0.2] } frequency 3 rotate 90*x } Tile(1, 2) }
box { -1, 1 pigment { average pigment_map { [1 wrinkles scale 0.5] [2 cells scale 0.3] } } Tile(2, 2) }
box { -1, 1 pigment { pigment_pattern { dents scale 0.3 } cubic_wave color_map { Sky_Map } noise_generator 3 } Tile(3, 2) }
