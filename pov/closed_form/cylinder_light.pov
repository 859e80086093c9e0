// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A cylinder light along +z, radius 1, falloff 2.5, tightness 2; r = sqrt(x^2 + y^2), w = 1 - r / 2.5, q = w / (1 - 1 / 2.5):
//     pixel = 0 for r >= 2.5, else 0.8 w^2, times q^2 (3 - 2 q) where r > 1
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -5>, rgb 1 cylinder point_at <0, 0, 0> radius 1 falloff 2.5 tightness 2 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.8 } }
