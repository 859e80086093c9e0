// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// Blinn's highlight on a black wall z = 0, a light at (-1, 0, -4). L = unit vector to the light, V = -z, H their bisector, N = -z:
//     pixel = (1, 0.9, 0.8) * 0.6 * (H . N)^(1 / 0.04)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <-1, 0, -4>, rgb <1, 0.9, 0.8> }
plane { -z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 specular 0.6 roughness 0.04 } }
