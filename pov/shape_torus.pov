// Tori: lying, standing, thin, fat, stretched, and a spindle whose tube reaches past its middle.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

torus { 0.9, 0.25 rotate <70, 0, 20> translate <-2, 0, 0> pigment { rgb <0.9, 0.4, 0.3> } finish { specular 0.5 } }
torus { 0.7, 0.04 rotate <20, 0, 30> pigment { rgb <0.9, 0.8, 0.3> } }
torus { 0.5, 0.45 translate <0, -0.55, -1.4> pigment { rgb <0.3, 0.8, 0.5> } }
torus { 0.4, 0.6 rotate 60*x translate <2, -0.2, 0> pigment { rgb <0.4, 0.5, 0.9> } finish { phong 0.5 } }
torus { 1, 0.2 scale <1.3, 2, 0.6> rotate 90*x translate <0.6, 1.2, 2> pigment { rgb 0.7 } }
