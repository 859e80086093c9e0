// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A checkered wall at z = 0.25, cells of size 0.7: n = floor(x / 0.7) + floor(y / 0.7) + floor(0.25 / 0.7)
//     pixel = (0.9, 0.8, 0.1) for even n, (0.1, 0.2, 0.6) for odd n
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

plane { -z, -0.25 pigment { checker rgb <0.9, 0.8, 0.1> rgb <0.1, 0.2, 0.6> scale 0.7 } finish { ambient 1 diffuse 0 } }
