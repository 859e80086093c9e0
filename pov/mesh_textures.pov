// Textures of a mesh's faces: one a face, or one a corner, mixed by the corners' weights; patterns, mirrors and transparent ones among them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0.2, 0> angle 45 }
light_source { <3, 6, -6>, 1 }
background { rgb <0.3, 0.4, 0.6> }
#default { finish { ambient 0.3 diffuse 0.6 } }
#declare Red = texture { pigment { rgb <1, 0.1, 0.1> } finish { phong 0.7 } }
#declare Squares = texture { pigment { checker rgb 1, rgb <0.1, 0.1, 0.5> scale 0.25 } }
#declare Mirror = texture { pigment { rgb <0.1, 0.2, 0.1> } finish { reflection 0.6 } }
#declare Clear = texture { pigment { rgbf <0.4, 1, 0.6, 0.9> } }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.6 } }
mesh {
  triangle { <-3, -0.8, 0>, <-1, -0.8, 0>, <-2, 1.4, 0.4> texture_list { Red Squares Mirror } }
  smooth_triangle { <-1, -0.8, 0>, <-0.5, 0, -1>, <0.6, 1, -1>, <0, 0.4, -1>, <-2, 1.4, 0.4>, <-0.3, 0.4, -1> texture { Squares } }
  triangle { <-1, -0.8, 0>, <0.6, 1, -1>, <0.2, -0.9, -0.6> }
  pigment { rgb <1, 0.8, 0.2> }
  rotate 10*y
}
mesh2 {
  vertex_vectors { 5, <1, -0.6, -1>, <3, -0.8, 0>, <2.8, 1.2, 0>, <0.8, 1.3, 0>, <2, 0.2, -1.4> }
  texture_list { 4, texture { Red }, texture { Clear }, texture { Mirror }, texture { pigment { granite scale 0.5 } normal { bumps 0.6 scale 0.1 } } }
  face_indices { 4, <0, 1, 4>, 0, 1, 2, <1, 2, 4>, 1, 1, 3, <2, 3, 4>, 3, <3, 0, 4> }
  texture { Squares }
  interior { ior 1.3 }
  translate -0.1*y
}
