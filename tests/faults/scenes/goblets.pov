// Glass in glass: a ball of liquid inside a bottle, and coloured panes whose shadows are tinted; POV-Ray's profile.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.5, 0.6, 0.7> }
camera { location <1.5, 2, -6> look_at <0, 0.6, 0> angle 40 }
light_source { <-4, 6, -5>, rgb <0.9, 0.85, 0.8> }
light_source { <5, 4, -2>, rgb <0.25, 0.3, 0.45> }
plane { y, -0.6 pigment { checker rgb <0.9, 0.85, 0.8>, rgb <0.35, 0.5, 0.4> } finish { ambient 0.1 diffuse 0.75 } }
sphere { <-0.7, 0.5, 0>, 1 pigment { rgbf <0.95, 1, 0.95, 0.9> } finish { ambient 0 diffuse 0.1 specular 0.5 roughness 0.02 reflection { 0, 1 fresnel } conserve_energy }
  interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color rgb <0.5, 0.9, 0.7> } }
sphere { <-0.6, 0.4, 0>, 0.55 pigment { rgbf <1, 0.6, 0.5, 0.8> } finish { ambient 0.05 diffuse 0.2 reflection { 0.02, 0.6 fresnel } } interior { ior 1.25 } }
box { <-0.6, -0.6, -0.05>, <0.6, 0.9, 0.05> pigment { rgbf <0.9, 0.5, 0.2, 0.75> } finish { ambient 0.1 diffuse 0.3 }
  rotate 25*y translate <1.3, 0, -0.8> interior { ior 1.2 } }
cylinder { <0.6, -0.6, 1.4>, <0.8, 1.5, 1.6>, 0.4 pigment { rgbt <0.4, 0.5, 0.9, 0.4> } finish { ambient 0.1 diffuse 0.5 specular 0.4 roughness 0.05 } }
