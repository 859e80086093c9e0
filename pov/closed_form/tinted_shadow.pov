// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// A lamp at (0, 0, -4) shines on the wall z = 0 through a coloured sheet at z = -2 that the camera does not see: colour (0.9, 0.5, 0.2), filter
// 0.6, transmit 0.3, size 1.5 x 1, so its shadow is 3 x 2. With r = sqrt(x^2 + y^2 + 16)
//     pixel = 0.8 * 4 / r, times 0.6 (0.9, 0.5, 0.2) + 0.3 where |x| < 1.5 and |y| < 1
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

light_source { <0, 0, -4>, rgb 1 }
polygon { 5, <-0.75, -0.5, -2>, <0.75, -0.5, -2>, <0.75, 0.5, -2>, <-0.75, 0.5, -2>, <-0.75, -0.5, -2> pigment { rgbft <0.9, 0.5, 0.2, 0.6, 0.3> } no_image }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.8 } }
