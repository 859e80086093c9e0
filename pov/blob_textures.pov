// Textures of a blob's components, mixed by the shares of their fields: moved, layered, transparent and bumped ones, a mirror, one that
// carves; components without one show the blob's own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at <0, 0, 0> right x*4/3 angle 44 }
light_source { <6, 12, -9>, 1 }
background { rgb <0.2, 0.3, 0.45> }
#default { finish { ambient 0.15 diffuse 0.7 } }
#declare Squares = texture { pigment { checker rgb <1, 0.9, 0.5>, rgb <0.1, 0.2, 0.6> scale 0.3 } }
plane { y, -2 pigment { checker rgb 0.8, rgb 0.5 } }
blob {
    threshold 0.5
    sphere { <-0.6, 0, 0>, 1.1, 1 pigment { rgb <1, 0.15, 0.1> } finish { phong 0.8 } }
    sphere { <0.6, 0.2, 0>, 1.1, 1 texture { Squares } rotate 20*z }
    cylinder { <0, -0.9, 0>, <0, 1.1, 0.2>, 0.6, 0.9 }
    sphere { <0, 0.2, -0.9>, 0.6, -0.7 pigment { rgb <0.9, 0.9, 0.2> } }
    pigment { gradient y color_map { [0 rgb <0.1, 0.6, 0.2>] [1 rgb <0.8, 1, 0.8>] } scale 0.4 }
    translate <-2, 0.7, 0>
}
blob {
    threshold 0.4
    sphere { <-0.5, 0, 0>, 1, 1 texture { pigment { rgb <0.2, 0.5, 0.9> } finish { reflection 0.5 } } }
    sphere { <0.5, 0, 0>, 1, 1 texture { pigment { rgb <0.9, 0.3, 0.6> } normal { bumps 0.8 scale 0.1 } } scale <1, 1.3, 1> }
    cylinder { <0, -1, 0>, <0, 0.6, 0>, 0.7, 0.8 texture { Squares } texture { pigment { rgbt <1, 1, 1, 0.6> } } translate -0.2*z }
    rotate 30*y
    translate <0.5, -0.3, 0>
}
blob {
    threshold 0.3
    sphere { <-0.4, 0, 0>, 0.9, 1 pigment { rgbf <0.5, 1, 0.7, 0.9> } }
    sphere { <0.4, 0.1, 0>, 0.9, 1 pigment { rgb <1, 0.6, 0.1> } }
    interior { ior 1.2 }
    translate <2.7, 0.5, 0>
}
