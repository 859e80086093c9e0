// Two facing mirrors and a glass ball at max_trace_level 4: rays beyond the limit are black, straight transmission does not count.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <0.6, 0.4, -2.8> look_at <0, 0, 3> right x*4/3 angle 70 }
light_source { <1, 2.5, -1>, rgb 1 }
plane { z, 3 pigment { rgb 0.1 } finish { reflection 0.85 } }
plane { z, -3 inverse pigment { rgb 0.1 } finish { reflection 0.85 } }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.3 } }
sphere { <-0.9, 0, 0.8>, 0.6 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <0.8, -0.3, 0.3>, 0.5 pigment { rgbf 0.95 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
disc { <0, 0.6, 1.8>, <0, 0.1, -1>, 0.5 pigment { rgbt <0.3, 0.9, 0.4, 0.7> } }
background { rgb <0.5, 0.6, 0.8> }
