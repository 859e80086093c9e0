#version 3.7;
global_settings { assumed_gamma 1 }
mesh2 { face_indices { 1, <0, 1, 2> } }
