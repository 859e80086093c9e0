// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A smooth triangle (-3, -2, 0), (3, -2, 0), (0, 2.5, 0) with the normals (-0.6, 0, -0.8), (0.6, 0, -0.8), (0, 0.6, -0.8), light along +z.
// With the barycentric weights b of (x, y) and n = their sum of the normals: pixel = -0.9 n_z / |n| inside, (0, 0, 0.2) outside.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -20>, rgb 1 parallel point_at <0, 0, 0> }
background { rgb <0, 0, 0.2> }
smooth_triangle { <-3, -2, 0>, <-0.6, 0, -0.8>, <3, -2, 0>, <0.6, 0, -0.8>, <0, 2.5, 0>, <0, 0.6, -0.8> pigment { rgb 1 } finish { ambient 0 diffuse 0.9 } }
