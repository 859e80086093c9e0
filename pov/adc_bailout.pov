// Two facing mirrors with adc_bailout 0.3: rays that could change the pixel by less are black.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 adc_bailout 0.3 }

camera { location <0.6, 0.4, -2.8> look_at <0, 0, 3> right x*4/3 angle 70 }
light_source { <1, 2.5, -1>, rgb 1 }
plane { z, 3 pigment { rgb 0.1 } finish { reflection 0.7 } }
plane { z, -3 pigment { rgb 0.1 } finish { reflection rgb <0.9, 0.7, 0.5> } }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.3 } }
sphere { <-0.9, 0, 0.8>, 0.6 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <0.8, -0.3, 0.3>, 0.5 pigment { rgbt <0.9, 0.9, 1, 0.5> } }
background { rgb <0.5, 0.6, 0.8> }
