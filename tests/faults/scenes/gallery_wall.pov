// Mirrors at an angle, discs and a polygon lit from behind, lamps with something behind them; POV-Ray's profile.
#version 3.7;
global_settings { assumed_gamma 2.2 max_trace_level 3 }
background { rgb <0.1, 0.15, 0.1> }
camera { location <0.5, 1.5, -6> look_at <0, 0.8, 0> angle 48 }
light_source { <2, 3.2, -2.5>, rgb <0.8, 0.9, 0.6> }
light_source { <-2.5, 1.5, 1.5>, rgb <0.7, 0.3, 0.3> }
plane { y, 0 pigment { rgb <0.4, 0.35, 0.3> } finish { ambient 0.2 diffuse 0.6 specular 0.3 roughness 0.15 } }
box { <-0.05, 0, -1.5>, <0.05, 2.5, 1.5> pigment { rgb <0.7, 0.7, 0.8> } finish { ambient 0.05 diffuse 0.2 reflection 0.7 } rotate 35*y translate <1.9, 0, 0.6> }
box { <-0.05, 0, -1.5>, <0.05, 2.5, 1.5> pigment { rgb <0.8, 0.7, 0.7> } finish { ambient 0.05 diffuse 0.2 reflection { 0.6 metallic } } rotate -50*y translate <-1.6, 0, 1.2> }
disc { <-0.3, 1.2, -0.5>, <0.3, 0.1, -1>, 0.8, 0.3 pigment { rgb <0.9, 0.7, 0.2> } finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.1 } }
polygon { 5, <-2.4, 0.1>, <-1.2, 0.1>, <-1.2, 1.3>, <-2.4, 1.3>, <-2.4, 0.1> pigment { rgb <0.3, 0.5, 0.9> } finish { ambient 0.1 diffuse 0.6 } rotate 15*y }
sphere { <2.4, 4, -3>, 0.6 pigment { rgb <0.9, 0.9, 0.9> } finish { ambient 0.2 diffuse 0.6 } }
cone { <0.9, 0, -1.2>, 0.6, <0.9, 1.3, -1>, 0 pigment { rgb <0.8, 0.3, 0.6> } finish { ambient 0.1 diffuse 0.6 specular 0.7 roughness 0.06 } scale <1, 1, 0.8> }
