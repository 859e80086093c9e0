// Coordinates that meshes state, and those of turned curves: v runs along the curve, however its pieces lie.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -6> look_at 0 angle 50 }
light_source { <3, 5, -6>, 1 }
#default { finish { ambient 0.6 diffuse 0.5 } }
#declare Squares = pigment { checker rgb <1, 0.8, 0.2>, rgb <0.1, 0.3, 0.6> scale 1 / 8 }
lathe { cubic_spline 6, <0.4, -1.4>, <0.9, -1>, <0.5, -0.2>, <0.8, 0.5>, <0.3, 1>, <0, 1.3> uv_mapping pigment { Squares } translate -2*x }
sor { 5, <0.5, -1.3>, <0.6, -1>, <0.9, -0.2>, <0.4, 0.6>, <0.3, 1> pigment { uv_mapping Squares } }
mesh {
  triangle { <1, -1, 0>, <2.6, -1, -0.4>, <1.2, 0, 0.3> uv_vectors <0, 0>, <1, 0>, <0, 1> }
  triangle { <2.6, -1, -0.4>, <1.2, 0, 0.3>, <2.6, 0.2, 0> }
  uv_mapping pigment { Squares }
}
mesh2 {
  vertex_vectors { 4, <1.1, 0.2, 0>, <2.6, 0.4, 0.4>, <2.5, 1.4, 0>, <1, 1.2, -0.3> }
  uv_vectors { 5, <0, 0>, <1.5, 0>, <1, 1>, <0, 0.5>, <0.3, 0.3> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  uv_indices { 2, <0, 1, 2>, <4, 2, 3> }
  pigment { uv_mapping Squares }
}
