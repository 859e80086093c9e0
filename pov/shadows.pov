// Hard shadows of all shapes on one floor, from a low light: silhouettes seen by shadow rays.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }

light_source { <-7, 4, -3>, rgb 1 }
background { rgb <0.6, 0.7, 0.8> }
plane { y, -1 pigment { rgb <0.8, 0.8, 0.75> } }
torus { 0.5, 0.15 rotate 80*x translate <-2.2, -0.3, 0.5> pigment { rgb <0.8, 0.4, 0.3> } }
box { -0.4, 0.4 rotate <30, 20, 40> translate <-0.6, -0.3, -0.4> pigment { rgb <0.4, 0.7, 0.4> } }
cone { <0.8, -1, 0.6>, 0.5, <0.8, 0.6, 0.6>, 0 pigment { rgb <0.4, 0.5, 0.8> } }
cylinder { <2, -1, -0.6>, <2, 0, -0.6>, 0.3 open pigment { rgb <0.8, 0.7, 0.3> } }
triangle { <-0.2, -1, -1.8>, <1, -1, -1.6>, <0.4, 0, -1.7> pigment { rgb <0.7, 0.3, 0.7> } }
disc { <2.6, 0.6, 1>, <-1, 0.2, -0.4>, 0.5, 0.2 pigment { rgb <0.3, 0.7, 0.8> } }
