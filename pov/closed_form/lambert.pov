// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A white wall z = 0 and a point light at (1, -0.5, -3): with r^2 = (x - 1)^2 + (y + 0.5)^2 + 9
//     pixel = (0.8, 0.5, 0.3) (0.1 + 0.7 * 3 / r)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <1, -0.5, -3>, rgb 1 }
plane { -z, 0 pigment { rgb <0.8, 0.5, 0.3> } finish { ambient 0.1 diffuse 0.7 } }
