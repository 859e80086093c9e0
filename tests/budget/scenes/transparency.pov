// The plain scene, with glass, a filter and a medium that fades.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
sphere { <-1.5, 0, 0>, 0.9 pigment { rgbt <0.9, 0.3, 0.3, 0.8> } interior { ior 1.5 fade_distance 1 fade_power 2 } }
sphere { <1.2, 0.2, 0.4>, 1.1 pigment { rgbf <0.3, 0.8, 0.3, 0.7> } }
sphere { <0, -0.8, -1.5>, 0.4 pigment { rgb <0.3, 0.4, 0.9> } }
