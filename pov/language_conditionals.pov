// Conditionals in and between statements, nested, with ifdef, undef, local and a macro that is never called.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

#declare Many = 3;
#declare Shade = 0.2;
#macro Unused(A, B) nothing here is read until it is called: sphere { wrong #if (A) #else #end #end
#ifdef (Shade) #declare Body = rgb <0.9, Shade, 0.3>; #else #error "unreachable" #end
#undef Shade
#ifndef (Shade) #local Glow = 0.3; #end
#if (Many > 5)
    sphere { 0, 3 }
#elseif (Many = 3)
    sphere { <-1.6, 0, 0>, 0.9 pigment { color Body } finish { ambient #if (Many & 1) Glow #else 0 #end } }
    #if (Many < 2) box { -1, 1 } #else box { <0, -1, -0.5>, <#if (1) 1.2, #else 7, #end 0.5, 0.6> pigment { rgb <0.3, 0.7, 0.4> } } #end
#else
    #error "unreachable"
#end
sphere { <2.2, -0.3, 0>, 0.7 pigment { rgb #if (version >= 3.7) <0.3, 0.4, 0.9> #else 0 #end } }
