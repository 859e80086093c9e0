// A picture around things in all four ways, as bumps and as values, and by the surfaces' own coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -8> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -1.2 pigment { image_map { png "picture.png" interpolate 2 } rotate 90*x scale 2 } }
sphere { <-2.4, 0.9, 0>, 0.8 pigment { image_map { png "picture.png" map_type 1 } rotate 20*y translate <-2.4, 0.9, 0> } }
cylinder { <-0.8, 0.1, 0>, <-0.8, 1.7, 0>, 0.6 pigment { image_map { png "picture.png" map_type 2 interpolate 3 } scale 1.6 translate <-0.8, 0.1, 0> } }
torus { 0.6, 0.25 pigment { image_map { "picture.png" map_type 5 interpolate 4 } scale 0.6 } rotate -60*x translate <0.8, 0.9, 0> }
box { <1.6, 0.1, -0.8>, <3.2, 1.7, 0.8> pigment { image_map { png "picture.png" once transmit all 0.3 } scale 1.2 translate <1.8, 0.3, 0> } }
sphere { <-2, -0.4, -1.5>, 0.7 pigment { rgb 0.8 } normal { bump_map { png "picture.png" map_type 1 interpolate 2 bump_size 2 } translate <-2, -0.4, -1.5> } }
sphere { 0, 0.7 pigment { uv_mapping checker rgb 1 rgb <0.8, 0.3, 0.1> scale <0.1, 0.2, 1> } rotate <30, 40, 0> translate <0, -0.4, -1.5> }
box { -0.6, 0.6 texture { uv_mapping pigment { image_pattern { png "picture.png" } color_map { [0 rgb <0, 0, 0.5>] [1 rgb <1, 1, 0.5>] } } } rotate 40*y translate <2, -0.4, -1.5> }
