// A view at cosines about 1e-6 under a lamp overhead, with Cook and Torrance's terms.
#version 3.7;
//! raytrace: D=beckmann G=cook-torrance
global_settings { assumed_gamma 1 }
camera { location <0, 1e-6, -1> direction z right 4/3*4e-6*x up 4e-6*y }
light_source { <1, 2, 3>, 1.2 }
plane { y, 0 pigment { rgb <0.9, 0.7, 0.4> } finish { ambient 0.02 diffuse 0.1 specular 0.9 roughness 0.8 } }
