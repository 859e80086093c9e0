// checker of colours and of pigments, scaled and turned, in two and three dimensions, as a pattern of whole textures too.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.3, 0.35, 0.5> rotate 30*y scale 0.7 } }
box { <-2.6, -1, -0.6>, <-1.2, 0.4, 0.8> pigment { checker pigment { rgb <0.9, 0.3, 0.2> } pigment { checker rgb 1 rgb 0 scale 0.1 } scale 0.35 } }
sphere { <0.2, 0, 0>, 1 texture { checker texture { pigment { rgb <0.8, 0.6, 0.2> } finish { reflection 0.3 phong 0.8 } } texture { pigment { rgb <0.1, 0.1, 0.3> } } scale 0.4 } }
box { -0.7, 0.7 pigment { checker scale 0.4 } rotate <30, 40, 0> translate <2.2, 0, 0> }
background { rgb <0.5, 0.6, 0.8> }
