// Glass with Fresnel reflection and energy conservation: ball, tilted slab and rod with total reflection inside.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }

#declare Glass = material { texture { pigment { rgbf <0.97, 0.99, 1, 0.95> } finish { ambient 0 diffuse 0.03 specular 0.6 roughness 0.005 reflection { 0, 1 fresnel } conserve_energy } } interior { ior 1.5 } }
sphere { <-2, 0, 0>, 1 material { Glass } }
box { <-0.7, -0.9, -0.3>, <0.7, 0.9, 0.3> rotate <10, 35, 5> material { Glass } }
cylinder { <1.4, -0.9, 0.6>, <2.6, 1, -0.4>, 0.45 material { Glass } }
