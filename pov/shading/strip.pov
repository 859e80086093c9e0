// Five spheres of roughness 0.25, 0.4, 0.55, 0.7 and 0.85 (alpha is its square), for one choice of D, G and F at a time: a light over the
// viewer's shoulder, and one far behind that grazes the edges. Copper unless the command line says otherwise.
//     --define Brightness=X   of the lamps, 1
#version 3.7;
//! raytrace: shading=cook-torrance s=1
global_settings { assumed_gamma 1 }
#ifndef (Brightness) #declare Brightness = 1; #end

camera { orthographic location <0, 0, -10> right 10.6*x up 2.2*y look_at 0 }
background { rgb <0.05, 0.055, 0.065> }
light_source { <-8, 9, -14>, rgb Brightness*<1.6, 1.55, 1.5> }
light_source { <10, 5, 9>, rgb Brightness*<0.5, 0.6, 0.75> }

#declare Black = pigment { rgb 0 }
#declare Copper = finish {
    ambient 0 diffuse 0 specular 1
    //! raytrace: eta=0.200,0.924,1.102 k=3.912,2.452,2.142
}
sphere { -4.2*x, 1 pigment { Black } finish { Copper roughness 0.25 } no_shadow }
sphere { -2.1*x, 1 pigment { Black } finish { Copper roughness 0.4 } no_shadow }
sphere { 0*x, 1 pigment { Black } finish { Copper roughness 0.55 } no_shadow }
sphere { 2.1*x, 1 pigment { Black } finish { Copper roughness 0.7 } no_shadow }
sphere { 4.2*x, 1 pigment { Black } finish { Copper roughness 0.85 } no_shadow }
