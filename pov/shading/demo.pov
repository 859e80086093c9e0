// A teapot in a hall under two lamps that circle it: the modes and materials of an early real-time demo of Cook and Torrance's model.
//     --define Mode=NAME      phong-lights ct-lights phong-env ct-env phong-both ct-both (default)
//     --define Material=NAME  shiny-gold (default) dull-gold dull-blue silver mirror
//     --define Weight=NAME    of the surroundings in the ct modes: albedo (default) fresnel ct-effects
//     --define First=X --define Second=X     brightness of the two lamps, 1
//     --clock X               the lamps' way round, 0 to 1; a fixed clock is a pause
// The surroundings are six pictures of surroundings.pov, given by --environment.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#include "teapot.inc"

#ifndef (Mode) #declare Mode = "ct-both"; #end
#ifndef (Material) #declare Material = "shiny-gold"; #end
#ifndef (Weight) #declare Weight = "albedo"; #end
#ifndef (First) #declare First = 1; #end
#ifndef (Second) #declare Second = 1; #end

// What a mode consists of: lamps, surroundings, and by whose model.
#declare Lamps = ((strcmp(Mode, "phong-env") != 0) & (strcmp(Mode, "ct-env") != 0));
#declare Hall = ((strcmp(Mode, "phong-lights") != 0) & (strcmp(Mode, "ct-lights") != 0));
#declare Phong = ((strcmp(Mode, "phong-lights") = 0) | (strcmp(Mode, "phong-env") = 0) | (strcmp(Mode, "phong-both") = 0));
#declare Cook = ((strcmp(Mode, "ct-lights") = 0) | (strcmp(Mode, "ct-env") = 0) | (strcmp(Mode, "ct-both") = 0));
#if (!Phong & !Cook) #error "Mode: phong-lights, ct-lights, phong-env, ct-env, phong-both or ct-both" #end

// Colour and share of the diffuse light; everything else of a material follows from its name inside the finish.
#declare Known = 0;
#if (strcmp(Material, "shiny-gold") = 0) #declare Known = 1; #declare Colour = rgb <1, 0.62, 0.16>; #declare Kd = 0.35; #end
#if (strcmp(Material, "dull-gold") = 0) #declare Known = 1; #declare Colour = rgb <1, 0.62, 0.16>; #declare Kd = 0.5; #end
#if (strcmp(Material, "dull-blue") = 0) #declare Known = 1; #declare Colour = rgb <0.1, 0.2, 0.7>; #declare Kd = 1; #end
#if (strcmp(Material, "silver") = 0) #declare Known = 1; #declare Colour = rgb <0.95, 0.93, 0.9>; #declare Kd = 0.25; #end
#if (strcmp(Material, "mirror") = 0) #declare Known = 1; #declare Colour = rgb 1; #declare Kd = 0; #end
#if (Cook & Kd > 0) #declare Kd = 0.8; #end  // there the highlight takes its share s first and leaves 1 - s
#if (!Known) #error "Material: shiny-gold, dull-gold, dull-blue, silver or mirror" #end

#if (strcmp(Weight, "albedo") != 0 & strcmp(Weight, "fresnel") != 0 & strcmp(Weight, "ct-effects") != 0) #error "Weight: albedo, fresnel or ct-effects" #end

#declare Surface = finish {
    ambient 0.1*Kd*Lamps diffuse Kd*Lamps
    #if (strcmp(Material, "shiny-gold") = 0)
        //! raytrace: material=shiny-gold exponent=120
    #end
    #if (strcmp(Material, "dull-gold") = 0)
        //! raytrace: material=dull-gold exponent=14
    #end
    #if (strcmp(Material, "dull-blue") = 0)
        //! raytrace: material=dull-blue exponent=10
    #end
    #if (strcmp(Material, "silver") = 0)
        //! raytrace: material=silver exponent=90
    #end
    #if (strcmp(Material, "mirror") = 0)
        //! raytrace: material=mirror exponent=1000
    #end
    #if (Phong)
        //! raytrace: shading=blinn-phong env=mirror
    #else
        //! raytrace: shading=cook-torrance D=beckmann G=cook-torrance F=conductor env=albedo
        #if (strcmp(Weight, "fresnel") = 0)
            //! raytrace: env=fresnel
        #end
        #if (strcmp(Weight, "ct-effects") = 0)
            //! raytrace: env=ct-effects
        #end
    #end
    #if (!Lamps)
        //! raytrace: shading=none
    #end
    #if (!Hall)
        //! raytrace: env=finish
    #end
}

camera { location <0.6, 2.2, -6> look_at <0.1, 0.72, 0> right x*4/3 angle 42 }

#declare Way = 360*clock;
light_source { <-3.4, 5.2, -4.2>, rgb First*<1, 0.88, 0.7> rotate Way*y }
light_source { <4.8, 2.6, -2.2>, rgb Second*<0.3, 0.42, 0.62> rotate -Way*y }

object { Teapot rotate 24*y pigment { Colour } finish { Surface } }

// The stand: a round table of dark stone with a brass rim.
#declare Stone = finish { ambient 0.05 diffuse 0.6 specular 0.5 roughness 0.2 reflection { 0.02, 0.4 falloff 4 } }
cylinder { -0.16*y, 0, 2.15 texture { checker texture { pigment { rgb <0.09, 0.1, 0.12> } finish { Stone } } texture { pigment { rgb <0.3, 0.3, 0.32> } finish { Stone } } rotate 30*y scale 0.55 } }
torus { 2.15, 0.1 translate -0.1*y pigment { rgb <0.8, 0.6, 0.3> } finish { ambient 0.02 diffuse 0.2 specular 0.8 roughness 0.25 metallic reflection { rgb <0.5, 0.36, 0.18> } } }
cylinder { -6*y, -0.16*y, 0.5 pigment { rgb <0.12, 0.12, 0.14> } finish { Stone } }
