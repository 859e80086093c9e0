// No look_at: direction, up and right are used as they are, not perpendicular and not unit (POV-Ray warns).
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0.5, -6> direction <0.05, -0.05, 1.6> up <0.12, 1, 0> right <1.3, 0.1, 0.05> }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

sphere { <-1.6, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { specular 0.4 } }
box { <-0.4, -1, -0.6>, <0.8, 0.6, 0.6> pigment { rgb <0.3, 0.7, 0.3> } rotate 20*y }
cone { <2.1, -1, 0>, 0.9, <2.1, 1.2, 0>, 0.1 pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.6 } }
