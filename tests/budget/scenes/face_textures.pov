// A mesh of two faces, textured by their corners; a blob of two textures, and a cut through two.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
mesh2 {
  vertex_vectors { 4, <-2, -1, 0>, <2, -1, 0>, <2, 1, 0.5>, <-2, 1, 0> }
  texture_list { 3, texture { pigment { rgb <1, 0, 0> } }, texture { pigment { rgb <0, 1, 0> } }, texture { pigment { rgb <0, 0, 1> } } }
  face_indices { 2, <0, 1, 2>, 0, 1, 2, <0, 2, 3>, 1 }
}
blob {
  threshold 0.5
  sphere { <-1, 1.2, 0>, 0.8, 1 pigment { rgb <1, 0, 0> } }
  sphere { <-0.4, 1.2, 0>, 0.8, 1 pigment { rgb <0, 0, 1> } }
}
difference {
  intersection { sphere { <1, 1.2, 0>, 0.7 pigment { rgb <1, 1, 0> } } sphere { <1.4, 1.2, 0>, 0.7 pigment { rgb <0, 1, 1> } } }
  sphere { <1.2, 1.2, -0.6>, 0.4 }
  cutaway_textures
}
