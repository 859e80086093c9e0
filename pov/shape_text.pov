// Letters of the fonts that come with POV-Ray, kerned, spaced out, climbing, turned to show their sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7.003> look_at <0, 0.5, 0> right x*4/3 angle 46 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
plane { y, -1.5 pigment { checker rgb 0.8, rgb 0.5 } }
#default { finish { ambient 0.15 diffuse 0.7 } }
text { ttf "timrom.ttf" "AVg8 &" 0.3, 0 translate <-2.601, 1.503, 0> pigment { rgb <1, 0.5, 0.4> } }
text { ttf "cyrvetic.ttf", "Qi%" 0.4, <0.1, 0.05, -0.1> rotate 15*y translate <0.607, 1.501, 0> pigment { rgb <0.5, 0.9, 0.4> } }
text { ttf "crystal" "x 0@" 0.5, 0.1*x rotate -25*y translate <-2.603, 0.201, 0> pigment { rgb <0.4, 0.6, 1> } }
text { internal 1 "To be" 0.2, 0 rotate 12*x translate <0.203, 0.302, 0> pigment { rgb <1, 0.9, 0.3> } }
text { ttf "povlogo.ttf" "P" 0.5, 0 scale 1.5 rotate 10*y translate <-0.5, -1.2, -1> pigment { rgb <0.9, 0.5, 0.9> } }
