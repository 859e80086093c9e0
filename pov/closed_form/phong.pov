// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A black wall z = 0 seen along +z, a light at (0.7, 0.4, -4). The mirrored view ray is -z, so with r = distance of the light
//     pixel = (0.8, 0.9, 1) * 0.75 * (4 / r)^12
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0.7, 0.4, -4>, rgb <0.8, 0.9, 1> }
plane { -z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 phong 0.75 phong_size 12 } }
