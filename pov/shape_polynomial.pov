// Quadrics, a cubic, a quartic, a sextic, and one stated by single terms.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 3, -14> look_at 0 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -20> rgb 0.9 }
quadric { <1, 2, 1>, <0.5, 0, 0>, <0, 0, 0>, -1 translate <-4, 2.5, 0> pigment { rgb <1, 0.5, 0.5> } }
quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 rotate <150, 0, 20> translate <6, -4, 8> pigment { rgb <0.5, 1, 0.5> } }
cubic { <1, 0, 0, 0.5, 0, 1, 0, 0, 0, -1, 1, 0, -1, 0.5, 0, 0, 0, 1, 0.25, 1> scale 0.5 translate <0, -3, 30> pigment { rgb <0.5, 0.5, 1> } }
quartic {
    <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.6, 0, 0, 0, 0, 1, 0, -2.4, 0, 0.64>
    sturm rotate <60, 0, 30> translate <0, 2, 0> pigment { rgb <1, 1, 0.5> }
}
poly { 6, <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, -1>
    rotate <20, 30, 0> translate <4, 2.5, 0> pigment { rgb <0.5, 1, 1> } }
polynomial { 4, xyz(4,0,0): 1, xyz(0,2,0): 1, xyz(0,0,2): 1, xyz(2,0,0): -1 rotate 40*y translate <-3, -1, -2> scale 1.3 pigment { rgb <1, 0.5, 1> } }
plane { y, -8 pigment { checker rgb 0.9, rgb 0.4 } }
