// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. Ray: origin (0, 2, 0), direction d = (4/3 u, v, 1) / its length.
// The lower half is an opaque dielectric with ior 1.5 under a white sky. With c = |d.y| and g = sqrt(1.5^2 + c^2 - 1)
//     pixel = 1 for v > 0, else 1/2 ((g - c) / (g + c))^2 (1 + ((c (g + c) - 1) / (c (g - c) + 1))^2)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, 0> right x*4/3 direction z }

background { rgb 1 }
plane { y, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } } interior { ior 1.5 } }
