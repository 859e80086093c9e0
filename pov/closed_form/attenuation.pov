// Pixel (i, j) of W x H, counted from the top left: u = (i + 1/2) / W - 1/2, v = 1/2 - (j + 1/2) / H. Ray: origin (0, 0, -4), direction (4/3 u, v, 1).
// A clear slab of thickness 1 before a white sky, crossed over s = sqrt((4/3 u)^2 + v^2 + 1); left of the middle it fades exponentially, on the
// right by a power law, fade_color f = (0.8, 0.5, 0.2), fade_distance 0.7:
//     pixel = exp(-(1 - f) s / 0.7) or f + (1 - f) / (1 + (s / 0.7)^2)
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0, -4> right x*4/3 direction z }
background { rgb 1 }
#declare Clear = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } }
#declare F = rgb <0.8, 0.5, 0.2>;
box { <-50, -50, 0>, <0, 50, 1> texture { Clear } interior { fade_distance 0.7 fade_power 1000 fade_color F } }
box { <0, -50, 0>, <50, 50, 1> texture { Clear } interior { fade_distance 0.7 fade_power 2 fade_color F } }
