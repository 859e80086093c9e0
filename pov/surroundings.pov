// A sky of two layers, ground fog and fog that tints, and a rainbow, seen directly, in a mirror and through glass.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -8> look_at <0, 1, 0> angle 60 }
light_source { <20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.1, 0.2> }
sky_sphere {
    pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.6 rgb <0.2, 0.3, 0.8>] } }
    pigment { bozo turbulence 0.5 color_map { [0.4 rgbt 1] [0.7 rgbt <1, 1, 1, 0.2>] } scale <0.4, 0.1, 0.4> }
    emission 0.8
}
fog { fog_type 2 distance 12 rgb <0.8, 0.8, 0.9> fog_offset 0.1 fog_alt 0.6 turbulence 0.2 }
fog { distance 60 rgbft <0.6, 0.7, 0.9, 0.3, 0.2> }
rainbow { direction <-0.2, -0.1, 1> angle 22 width 6 distance 30 arc_angle 160 falloff_angle 100
    color_map { [0 rgbt <0.6, 0.2, 0.8, 0.9>] [0.5 rgbt <0.2, 0.9, 0.3, 0.6>] [1 rgbft <1, 0.2, 0.1, 0.2, 0.9>] } }
plane { y, -1 pigment { checker rgb 0.6 rgb 0.3 } hollow }
sphere { <-1.5, 0.3, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.7 } }
sphere { <1.5, 0.3, 0>, 1 pigment { rgbt <0.9, 1, 0.9, 0.9> } interior { ior 1.3 } }
