// A mesh with smooth and flat faces, squeezed, and a glass gem of flat ones that reflects totally; POV-Ray's profile.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.3, 0.25, 0.2> }
camera { location <0, 2.6, -5.5> look_at <0, 0.2, 0> angle 44 }
light_source { <3, 6, -5>, rgb <1, 0.9, 0.8> }
light_source { <-5, 3, -3>, rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { rgb <0.55, 0.5, 0.6> } finish { ambient 0.15 diffuse 0.7 specular 0.2 roughness 0.2 reflection 0.2 } }
mesh2 { vertex_vectors { 6, <0, 1, 0>, <1, 0, 0>, <0, 0, -1>, <-1, 0, 0>, <0, 0, 1>, <0, -1, 0> }
  normal_vectors { 6, <0, 1, 0>, <1, 0, 0>, <0, 0, -1>, <-1, 0, 0>, <0, 0, 1>, <0, -1, 0> }
  face_indices { 8, <0, 1, 2>, <0, 2, 3>, <0, 3, 4>, <0, 4, 1>, <5, 2, 1>, <5, 3, 2>, <5, 4, 3>, <5, 1, 4> }
  pigment { rgb <0.3, 0.6, 0.5> } finish { ambient 0.1 diffuse 0.6 specular 0.5 roughness 0.1 }
  scale <0.8, 1.1, 0.5> rotate <0, 25, 15> translate <-1.3, 0.1, 0.2> }
mesh2 { vertex_vectors { 5, <0, 1.2, 0>, <0.9, -0.5, -0.8>, <-0.9, -0.5, -0.8>, <-0.9, -0.5, 0.8>, <0.9, -0.5, 0.8> }
  face_indices { 6, <0, 1, 2>, <0, 2, 3>, <0, 3, 4>, <0, 4, 1>, <1, 4, 3>, <1, 3, 2> }
  pigment { rgbf <1, 0.9, 0.85, 0.9> } finish { ambient 0.02 diffuse 0.1 specular 0.6 roughness 0.03 reflection { 0.05, 0.9 fresnel } }
  interior { ior 1.7 } rotate 20*y translate <1, -0.2, -0.3> }
