// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A sphere of radius 2 lit by parallel light along the view; with s = 1 - (x^2 + y^2) / 4
//     pixel = (0.2, 0.3, 0.4) where s < 0, else (0.9, 0.6, 0.3) sqrt(s) * 0.8
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -20>, rgb 1 parallel point_at <0, 0, 0> }
sphere { 0, 2 pigment { rgb <0.9, 0.6, 0.3> } finish { ambient 0 diffuse 0.8 } }
background { rgb <0.2, 0.3, 0.4> }
