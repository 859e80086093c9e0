// A lamp 1e-7 above the plane it lights, with a lobe wider than the hemisphere.
#version 3.7;
//! raytrace: D=ggx G=ggx F=dielectric
global_settings { assumed_gamma 1 }
camera { location <0, 1, -2> direction z right 4/3*x up y look_at <0, 0, 0> }
light_source { <0.3, 1e-7, 1>, 3e8 }
plane { y, 0 pigment { rgb <0.9, 0.7, 0.4> } finish { ambient 0.02 diffuse 0.02 specular 0.9 roughness 2 } }
sphere { <-0.6, 0.3, 0>, 0.3 pigment { rgb <0.2, 0.5, 0.9> } finish { ambient 0.02 diffuse 1e-9 specular 1e-8 roughness 1 } }
