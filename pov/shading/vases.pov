// Vases in Gooch's warm and cool tones, with the highlight of Cook and Torrance over them and lines along their edges.
#version 3.7;
//! raytrace: preset=gooch-ct edges=all edge-width=1.6 edge-angle=40
global_settings { assumed_gamma 1 }
#include "vases.inc"

camera { location <0.4, 2.9, -7.6> look_at <0.05, 0.8, 0> right x*16/9 angle 61 }
background { rgb <0.86, 0.85, 0.8> }
light_source { <-5, 7, -6>, rgb 1 }

#declare Glaze = finish { ambient 0 diffuse 1 specular 0.8 roughness 0.36 }
object { Ribbed rotate 10*y scale 1.12 translate <-2.75, 0, 0.3> pigment { rgb <0.7, 0.16, 0.1> } finish { Glaze } }
object { Amphora rotate 14*y translate <-0.5, 0, 0.5> pigment { rgb <0.12, 0.45, 0.3> } finish { Glaze } }
object { Bowl scale 1.1 translate <2.25, 0, -0.1> pigment { rgb <0.2, 0.3, 0.75> } finish { Glaze } }
#declare Chalk = finish { ambient 0 diffuse 1 specular 0 }
box { <-3.7, -0.22, -1.3>, <3.7, 0, 1.7> pigment { rgb 0.62 } finish { Chalk } }
box { <-3.95, -0.44, -1.55>, <3.95, -0.22, 1.7> pigment { rgb 0.62 } finish { Chalk } }
