// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. Ray: origin (0, 2, 0), direction d = (4/3 u, v, 1) / its length.
// The lower half is a mirror y = 0 whose reflectivity runs with 1 - cos from 0.1 to 0.9; the sky is (0.4, 0.6, 0.9). With c = |d.y|:
//     pixel = sky for v > 0, else 0.05 + sky (0.9 (1 - c) + 0.1 c)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, 0> right x*4/3 direction z }

background { rgb <0.4, 0.6, 0.9> }
plane { y, 0 pigment { rgb 1 } finish { ambient 0.05 diffuse 0 reflection { 0.1, 0.9 } } }
