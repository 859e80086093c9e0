// The camera stands under water (inside a box with ior 1.33): beyond the critical angle the surface is a mirror. An ior below 1 reflects totally from outside.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }

camera { location <0, -0.6, -3> look_at <0, 0.2, 0> right x*4/3 angle 70 }
light_source { <3, 8, -2>, rgb 1 }
background { rgb <0.7, 0.8, 1> }
box { <-20, -3, -20>, <20, 0.5, 20> pigment { rgbf <0.85, 0.95, 1, 1> } finish { ambient 0 diffuse 0 } interior { ior 1.33 } }
plane { y, -2 pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.5, 0.4, 0.3> } }
sphere { <-1, -0.9, 1>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 } }
sphere { <0.8, 1.2, 2>, 0.6 pigment { rgb <0.2, 0.6, 0.3> } }
sphere { <0.7, -0.8, 0.2>, 0.35 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 0.8 } }
