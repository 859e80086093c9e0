// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. It looks along +z at x = 8 u, y = 6 v.
// Two layers over a wall, all ambient. On top c1 = (0.2, 0.4, 0.8) with filter 0.5 and transmit 0.2, below it c2 = (0.9, 0.5, 0.1) with
// transmit 0.4, behind it the wall (0.3, 0.6, 0.9); ambient 0.8 everywhere. With W1 = 0.5 c1 + 0.2, for |x| < 2, |y| < 1.5
//     pixel = 0.8 (0.3 c1 + W1 (0.6 c2 + 0.4 wall)), elsewhere 0.8 wall
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> right x*8 up y*6 look_at 0 }

#default { finish { ambient 0.8 diffuse 0 } }
polygon { 5, <-2, -1.5, -1>, <2, -1.5, -1>, <2, 1.5, -1>, <-2, 1.5, -1>, <-2, -1.5, -1>
    texture { pigment { rgbt <0.9, 0.5, 0.1, 0.4> } }
    texture { pigment { rgbft <0.2, 0.4, 0.8, 0.5, 0.2> } }
}
plane { -z, 0 pigment { rgb <0.3, 0.6, 0.9> } }
