// A still life without a choice of its own but for widths: for presets, terms and variants given on the command line, one beside the other.
//     --define Brightness=X   of the lamps, 1
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
#include "teapot.inc"
#include "vases.inc"
#ifndef (Brightness) #declare Brightness = 1; #end

camera { location <0.2, 2.5, -6.4> look_at <0.1, 0.85, 0> right x*4/3 angle 40 }
light_source { <-4, 6, -5>, rgb Brightness*<1.6, 1.48, 1.3> }
light_source { <4.5, 3.5, 5>, rgb Brightness*<0.7, 0.85, 1.05> }

object { Teapot rotate 20*y scale 0.95 translate <-0.75, 0, 0.2> pigment { rgb <0.66, 0.09, 0.06> } finish { ambient 0.08 diffuse 0.8 specular 0.5 roughness 0.42 } interior { ior 2 } }
object { Ribbed rotate 5*y scale 1.05 translate <1.35, 0, 1.2> pigment { rgb <0.08, 0.3, 0.42> } finish { ambient 0.08 diffuse 0.8 specular 0.5 roughness 0.5 } interior { ior 2 } }
sphere { <1.35, 0.45, -0.85>, 0.45 pigment { rgb <0.8, 0.62, 0.3> } finish { ambient 0.08 diffuse 0.6 specular 0.6 roughness 0.5 } interior { ior 4 } }
plane { y, 0 pigment { rgb <0.5, 0.48, 0.45> } finish { ambient 0.08 diffuse 0.7 specular 0.25 roughness 0.55 } }
plane { -z, -3.5 pigment { rgb <0.3, 0.34, 0.4> } finish { ambient 0.08 diffuse 0.7 } }
