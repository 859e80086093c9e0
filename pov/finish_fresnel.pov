// Fresnel reflection on opaque spheres with an interior: two indices, a minimum, and without an index, where it vanishes.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }

sphere { <-2.1, 0.5, 0>, 1 pigment { rgb 0.05 } finish { reflection { 1 fresnel } } interior { ior 1.5 } }
sphere { <0, 0.5, 0>, 1 pigment { rgb <0.3, 0.05, 0.05> } finish { reflection { 0.1, 0.9 fresnel on } } interior { ior 2.4 } }
sphere { <2.1, 0.5, 0>, 1 pigment { rgb <0.1, 0.2, 0.3> } finish { reflection { 1 fresnel } } }
