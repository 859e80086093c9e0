// Showcase: a golden trefoil knot above a pedestal among glass, gems and mirrors before a wall of two lights. Render it wide: 960x540.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 14 }

#include "knot.inc"
#include "gem.inc"

camera { location <0.6, 2.7, -10.4> look_at <0.05, 1.62, 0> right x*16/9 angle 56 }
background { rgb <0.2, 0.22, 0.3> }

// A warm key light, large enough for soft shadows; a cool rim light; coloured spots for the wall and their glow on everything.
light_source { <7, 9, -8>, rgb <1.15, 1.02, 0.84> area_light <2.2, 0, 0>, <0, 2.2, 0>, 5, 5 adaptive 1 circular orient }
light_source { <-9, 6, -3>, rgb <0.16, 0.24, 0.45> }
light_source { <-5, 5, 3>, rgb <0.1, 1.7, 2.9> spotlight point_at <-4.5, 2.5, 9> radius 12 falloff 46 tightness 4 }
light_source { <6, 5, 3>, rgb <3.1, 0.5, 1.3> spotlight point_at <5, 2, 9> radius 10 falloff 46 tightness 4 }
light_source { <-6, 4, 5>, rgb <0.05, 0.5, 0.8> shadowless }
light_source { <7, 4, 5>, rgb <0.9, 0.15, 0.35> shadowless }

#declare Ivory = pigment { rgb <0.5, 0.44, 0.35> }
#declare Ebony = pigment { rgb <0.035, 0.04, 0.06> }
#declare Polished = finish { ambient 0.02 diffuse 0.7 specular 0.3 roughness 0.01 reflection { 0.03, 0.5 falloff 3 } }
plane { y, 0 texture { checker texture { pigment { Ivory } finish { Polished } } texture { pigment { Ebony } finish { Polished } } rotate 45*y scale 1.1 } }
plane { -z, -9 pigment { rgb <0.09, 0.1, 0.15> } finish { ambient 0 diffuse 0.8 } }

#declare Gold = texture {
    pigment { rgb <1, 0.6, 0.18> }
    finish { ambient 0.03 diffuse 0.35 brilliance 2 specular 0.9 roughness 0.025 metallic reflection { 0.5 metallic } }
}
#declare Chrome = texture { pigment { rgb <0.75, 0.78, 0.82> } finish { ambient 0 diffuse 0.1 specular 0.9 roughness 0.004 reflection { 0.75 metallic } } }
#declare Glass = texture { pigment { rgbf <0.98, 0.99, 1, 0.97> } finish { ambient 0 diffuse 0 specular 0.9 roughness 0.002 reflection { 0, 1 fresnel } conserve_energy } }
#declare Lacquer = finish { ambient 0.04 diffuse 0.7 phong 0.5 phong_size 90 reflection { 0.02, 0.45 falloff 3 } }

object { Knot rotate <0, 0, 20> rotate <-12, 24, 0> translate <0, 2.65, 0.4> texture { Gold } }
cylinder { <0, 0, 0.4>, <0, 0.5, 0.4>, 1.15 pigment { rgb <0.12, 0.13, 0.16> } finish { Polished } }
torus { 1.15, 0.07 translate <0, 0.5, 0.4> texture { Gold } }

sphere { <-3.2, 1.15, -0.4>, 1.15 texture { Glass } interior { ior 1.5 caustics 0.5 } }
sphere { <3.4, 1.05, 0.4>, 1.05 texture { Chrome } }

#declare Cut = finish { ambient 0 diffuse 0 specular 0.9 roughness 0.002 reflection { 0, 1 fresnel } conserve_energy }
object { Gem rotate <0, 10, 0> rotate <-42, 0, 8> scale 0.62 translate <1.75, 0.43, -2.6> pigment { rgbf <1, 1, 1, 0.98> } finish { Cut } interior { ior 1.75 fade_distance 0.28 fade_power 1001 fade_color rgb <0.98, 0.03, 0.12> } }
object { Gem rotate <0, 25, 0> rotate <-42, 30, -6> scale 0.5 translate <-1.15, 0.36, -3> pigment { rgbf <1, 1, 1, 0.98> } finish { Cut } interior { ior 1.75 fade_distance 0.28 fade_power 1001 fade_color rgb <0.05, 0.85, 0.35> } }
object { Gem rotate <0, 5, 0> rotate <-42, -25, 0> scale 0.42 translate <0.35, 0.31, -3.5> pigment { rgbf <1, 1, 1, 0.98> } finish { Cut } interior { ior 1.75 fade_distance 0.28 fade_power 1001 fade_color rgb <0.08, 0.32, 1> } }

sphere { <-1.9, 0.4, -1.4>, 0.4 pigment { rgb <0.75, 0.1, 0.08> } finish { Lacquer } }
sphere { <2.2, 0.3, -1.1>, 0.3 pigment { rgb <0.06, 0.28, 0.6> } finish { Lacquer } }
sphere { <-4.6, 0.45, 1.6>, 0.45 pigment { rgb <0.9, 0.55, 0.08> } finish { Lacquer } }
sphere { <4.4, 0.35, -1.7>, 0.35 texture { Gold } }
sphere { <-2.6, 0.25, -3.1>, 0.25 texture { Chrome } }
torus { 0.55, 0.16 rotate <78, 0, 0> rotate 35*y translate <4.9, 0.7, 2.2> pigment { rgb <0.1, 0.5, 0.42> } finish { Lacquer } }
