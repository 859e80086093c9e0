// Lathes of all splines and surfaces of revolution, closed and open, upright, lying and stretched.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -10> look_at <0, 0, 0> right x*4/3 angle 46 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
plane { y, -3 pigment { checker rgb 0.8, rgb 0.5 } }
#default { finish { ambient 0.15 diffuse 0.7 phong 0.4 } }
lathe { linear_spline 5, <0.2, -1>, <1, -0.8>, <0.4, 0>, <0.9, 0.9>, <0, 1.2> translate <-3.4, 1.4, 0> pigment { rgb <1, 0.5, 0.4> } }
lathe { quadratic_spline 6, <0.2, -1.2>, <0.6, -1>, <1.2, -0.4>, <0.3, 0.2>, <0.7, 0.9>, <0.2, 1.2> rotate <20, 0, 15> translate <-1, 1.4, 0> pigment { rgb <0.5, 0.9, 0.4> } }
lathe { cubic_spline 7, <0, -1.4>, <0.1, -1>, <1, -0.7>, <0.4, 0>, <0.9, 0.7>, <0.2, 1.1>, <0, 1.4> sturm rotate -30*x translate <1.5, 1.4, 0> pigment { rgb <0.4, 0.6, 1> } }
lathe { bezier_spline 8, <0.3, -1.1>, <1.5, -1>, <0.2, -0.2>, <0.7, 0.1>, <0.7, 0.1>, <1.1, 0.5>, <0.9, 1>, <0.1, 1.2> translate <3.8, 1.2, 0> pigment { rgb <1, 0.9, 0.3> } }
sor { 7, <0, -1.4>, <0.6, -1.2>, <1, -0.4>, <0.3, 0.3>, <0.5, 0.8>, <0.8, 1.1>, <0.8, 1.3> translate <-2.6, -1.6, -1> pigment { rgb <0.9, 0.5, 0.9> } }
sor { 6, <1, -1.4>, <0.9, -1>, <0.5, -0.3>, <0.9, 0.5>, <0.6, 1>, <0.4, 1.4> open rotate <-50, 0, 20> scale <1.2, 1, 1> translate <0.5, -1.4, -1> pigment { rgb <0.5, 0.9, 0.9> } }
lathe { linear_spline 5, <0.5, -0.5>, <1.2, -0.5>, <1.2, 0.5>, <0.5, 0.5>, <0.5, -0.5> rotate 60*x translate <3.4, -1.6, -1> pigment { rgb <0.8, 0.8, 0.8> } }
