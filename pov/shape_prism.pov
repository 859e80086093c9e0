// Prisms of all splines, straight and conic, with a hole, open, and of heights in any order.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -11> look_at <0, 0.2, 0> right x*4/3 angle 46 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.5 } }
#default { finish { ambient 0.15 diffuse 0.7 phong 0.4 } }
prism { -1, 0.3, 9, <-1, -1>, <1, -1>, <1.2, 0.8>, <0, 1.4>, <-1, -1>, <-0.2, -0.4>, <0.6, -0.4>, <0.3, 0.5>, <-0.2, -0.4> translate <-3.6, 0, 1.8> pigment { rgb <1, 0.5, 0.4> } }
prism { quadratic_spline 0.5, -1, 6, <-1, 1>, <-1, -1>, <1, -1.2>, <1.3, 1>, <-0.2, 1.2>, <-1, -1> translate <0, 0, 2> pigment { rgb <0.5, 0.9, 0.4> } }
prism { cubic_spline linear_sweep -1, 0.4, 7, <-1, 1>, <-1, -1>, <0.5, -0.7>, <1.2, 0.4>, <0, 1.1>, <-1, -1>, <0.5, -0.7> open translate <3.4, 0, 2> pigment { rgb <0.4, 0.6, 1> } }
prism { bezier_spline -1, 0, 12, <-1, -1>, <0, -1.6>, <0.6, -1>, <1, -0.8>, <1, -0.8>, <1.4, 0>, <0.8, 0.9>, <0, 1>, <0, 1>, <-0.6, 1.1>, <-1.5, 0>, <-1, -1> translate <-3.4, 0, -1.4> pigment { rgb <1, 0.9, 0.3> } }
prism { conic_sweep 0.3, 1, 5, <-1, -1>, <1.2, -1>, <1, 0.8>, <-0.6, 1>, <-1, -1> rotate 180*x scale <1, 2, 1> translate <0, 1, -1.4> pigment { rgb <0.9, 0.5, 0.9> } }
prism { conic_sweep bezier_spline 0, 1, 8, <-1, 0>, <-1, -1.3>, <1, -1.3>, <1, 0>, <1, 0>, <0.6, 1>, <-0.6, 1>, <-1, 0> rotate 180*x scale <1, 2.5, 1> translate <3.2, 1.5, -1.2> pigment { rgb <0.5, 0.9, 0.9> } }
