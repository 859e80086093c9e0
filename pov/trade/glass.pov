// Glass in glass before a pattern: rays split at every surface, and most of the picture is what comes through several.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }

camera { location <0, 1.8, -6> look_at <0, 0.5, 0> right x*4/3 angle 42 }
background { rgb <0.5, 0.65, 0.9> }
light_source { <5, 8, -6>, rgb 1 }

#declare Dull = finish { ambient 0.15 diffuse 0.7 }
plane { y, -0.5 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> scale 0.7 } finish { Dull } }
plane { -z, -5 pigment { checker rgb <0.3, 0.4, 0.5> rgb <0.75, 0.75, 0.7> scale 0.9 } finish { Dull } }

#declare Glass = material { texture { pigment { rgbf <0.97, 0.99, 1, 0.95> } finish { ambient 0 diffuse 0.03 specular 0.6 roughness 0.1 reflection { 0, 1 fresnel } conserve_energy } } interior { ior 1.5 } }
sphere { <-1.6, 0.6, 0>, 1.1 material { Glass } }
sphere { <-1.6, 0.6, 0>, 0.6 pigment { rgbf <0.6, 0.9, 0.7, 0.9> } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.1 } }
box { <-0.55, -0.5, -0.4>, <0.55, 1.3, 0.4> rotate 30*y translate <0.5, 0, -0.4> material { Glass } }
cylinder { <2, -0.4, 0.4>, <2.5, 1.6, 0.2>, 0.5 material { Glass } }
