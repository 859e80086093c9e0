// One of each other shape.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
box { <-2, -0.5, -0.5>, <-1.2, 0.5, 0.5> pigment { rgb <0.9, 0.3, 0.3> } }
cone { <-0.5, -0.5, 0>, 0.5, <-0.5, 0.7, 0>, 0.1 pigment { rgb <0.3, 0.8, 0.3> } }
torus { 0.5, 0.2 rotate 60*x translate <0.8, 0, 0> pigment { rgb <0.3, 0.4, 0.9> } }
disc { <1.9, 0, 0>, <-0.4, 0, -1>, 0.5 pigment { rgb <0.9, 0.8, 0.3> } }
polygon { 5, <-1, 0.8>, <1, 0.8>, <1, 1.3>, <-1, 1.3>, <-1, 0.8> pigment { rgb <0.7, 0.7, 0.8> } }
