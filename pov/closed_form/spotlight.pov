// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A spotlight at (0, 0, -5) that shines at the origin, radius 15, falloff 30, tightness 4. a = 5 / sqrt(x^2 + y^2 + 25) is both the cosine to
// the axis and that on the wall; q = (a - cos 30) / (cos 15 - cos 30) clamped to 0..1:
//     pixel = 0.9 a * a^4 * q^2 (3 - 2 q)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -5>, rgb 1 spotlight point_at <0, 0, 0> radius 15 falloff 30 tightness 4 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.9 } }
