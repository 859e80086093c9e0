// Every form of colour: rgb, rgbf, rgbt, rgbft, components after a vector, single keywords, srgb, and colours from arithmetic.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right x*8 up y*6 look_at 0 }
light_source { <2, 3, -20>, rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
#declare Warm = rgb <0.8, 0.4, 0.2>;
#default { finish { ambient 0.3 diffuse 0.6 } }
box { <-3.8, 1.1, 0>, <-2.2, 2.8, 1> pigment { rgb <0.9, 0.2, 0.1> } }
box { <-1.8, 1.1, 0>, <-0.2, 2.8, 1> pigment { color rgbf <0.9, 0.8, 0.1, 0.6> } }
box { <0.2, 1.1, 0>, <1.8, 2.8, 1> pigment { rgbt <0.2, 0.8, 0.3, 0.4> } }
box { <2.2, 1.1, 0>, <3.8, 2.8, 1> pigment { colour rgbft <0.3, 0.4, 0.9, 0.3, 0.3> } }
box { <-3.8, -0.9, 0>, <-2.2, 0.8, 1> pigment { rgb <1, 0, 0> green 0.5 transmit 0.3 } }
box { <-1.8, -0.9, 0>, <-0.2, 0.8, 1> pigment { color red 0.3 green 0.6 blue 0.9 filter 0.2 } }
box { <0.2, -0.9, 0>, <1.8, 0.8, 1> pigment { srgb <0.5, 0.7, 0.9> } }
box { <2.2, -0.9, 0>, <3.8, 0.8, 1> pigment { color Warm * 0.5 + 0.2 } }
box { <-3.8, -2.8, 0>, <-2.2, -1.2, 1> pigment { color Warm } }
box { <-1.8, -2.8, 0>, <-0.2, -1.2, 1> pigment { rgb Warm.red * <0.2, 0.9, 0.7> } }
box { <0.2, -2.8, 0>, <1.8, -1.2, 1> pigment { rgb 0.5 } }
box { <2.2, -2.8, 0>, <3.8, -1.2, 1> pigment { rgbt 1 } finish { ambient 0.7 } }
