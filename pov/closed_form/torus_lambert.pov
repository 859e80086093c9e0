// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A torus of radii 1.8 and 0.6 seen along its axis, lit along the view. With q = 1 - ((sqrt(x^2 + y^2) - 1.8) / 0.6)^2
//     pixel = (0.1, 0.2, 0.3) where q < 0, else (0.9, 0.8, 0.4) * 0.9 sqrt(q)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -20>, rgb 1 parallel point_at <0, 0, 0> }
background { rgb <0.1, 0.2, 0.3> }
torus { 1.8, 0.6 rotate 90*x pigment { rgb <0.9, 0.8, 0.4> } finish { ambient 0 diffuse 0.9 } }
