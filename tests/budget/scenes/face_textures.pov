// A mesh of two faces, textured by their corners.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
mesh2 {
  vertex_vectors { 4, <-2, -1, 0>, <2, -1, 0>, <2, 1, 0.5>, <-2, 1, 0> }
  texture_list { 3, texture { pigment { rgb <1, 0, 0> } }, texture { pigment { rgb <0, 1, 0> } }, texture { pigment { rgb <0, 0, 1> } } }
  face_indices { 2, <0, 1, 2>, 0, 1, 2, <0, 2, 3>, 1 }
}
