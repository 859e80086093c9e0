// Phong's reflection under three kinds of lamps: parallel rays; a point whose light thins out as 1/(1 + d + d^2); a spot across whose beam it
// falls by a power of the cosine.
//     --define Lamp=NAME   parallel, point, spot or all (default)
//     --define Power=X     exponent of the spot, 24
#version 3.7;
//! raytrace: preset=phong-lights
global_settings { assumed_gamma 1 }
#include "vases.inc"

#ifndef (Lamp) #declare Lamp = "all"; #end
#ifndef (Power) #declare Power = 24; #end
#declare All = (strcmp(Lamp, "all") = 0);
#declare Known = All;

camera { location <0, 2.3, -7> look_at <0, 1.25, 0> right x*4/3 angle 44 }

#if (All | strcmp(Lamp, "parallel") = 0) #declare Known = 1; light_source { <-60, 80, -50>, rgb <1, 0.95, 0.86>*(1 - 0.7*All) parallel point_at 0 } #end
#if (All | strcmp(Lamp, "point") = 0) #declare Known = 1; light_source { <0.15, 1.2, -1.7>, rgb 5.5*<1, 0.62, 0.32>*(1 - 0.2*All) } #end
#if (All | strcmp(Lamp, "spot") = 0)
    #declare Known = 1;
    //! raytrace: spot=exponent
    light_source { <2.6, 4.6, -2.6>, rgb 60*<0.5, 0.72, 1> spotlight point_at <0.9, 0.7, 0.3> radius 30 falloff 60 tightness Power }
#end
#if (!Known) #error "Lamp: parallel, point, spot or all" #end

#declare Clay = finish { ambient 0.05 diffuse 0.75 specular 0.35 roughness 0.2 }
object { Amphora rotate 20*y translate <-1.25, 0, 0.5> pigment { rgb <0.85, 0.5, 0.32> } finish { Clay } }
object { Bowl scale 0.85 translate <1.25, 0, 0.35> pigment { rgb <0.5, 0.7, 0.45> } finish { Clay } }
sphere { <0.15, 0.34, -0.75>, 0.34 pigment { rgb <0.85, 0.83, 0.8> } finish { Clay } }
#declare Wall = finish { ambient 0.05 diffuse 0.7 specular 0 }
plane { y, 0 texture { checker texture { pigment { rgb 0.75 } finish { Wall } } texture { pigment { rgb 0.5 } finish { Wall } } scale 0.8 } }
plane { -z, -2.2 pigment { rgb <0.7, 0.7, 0.72> } finish { Wall } }
