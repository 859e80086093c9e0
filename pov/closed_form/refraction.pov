// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. Ray: origin (0, 0, -4), direction (4/3 u, v, 1).
// A slab of ior 1.5 between z = 0 and z = 1 moves the ray sideways; behind it a wall z = 3 is lit by a light at (0, 0, 2), which no slab hides.
// With t = tan of the ray's angle to z and t' = that inside (sin = 1.5 sin'), the ray meets the wall at distance R = 6 t + t' from the axis:
//     pixel = (1, 0.8, 0.6) * 0.9 / sqrt(R^2 + 1)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -4> right x*4/3 direction z }
light_source { <0, 0, 2>, rgb 1 }
box { <-50, -50, 0>, <50, 50, 1> pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
plane { -z, -3 pigment { rgb <1, 0.8, 0.6> } finish { ambient 0 diffuse 0.9 } }
