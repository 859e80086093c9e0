// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// The wall again; the light (0.9, 0.8, 0.7) at (0, 0, -2) fades with distance r = sqrt(x^2 + y^2 + 4):
//     pixel = light * 0.6 * 2 / r * 2 / (1 + (r / 2.5)^3)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -2>, rgb <0.9, 0.8, 0.7> fade_distance 2.5 fade_power 3 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.6 } }
