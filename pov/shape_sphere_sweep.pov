// Sphere sweeps of all three kinds, one that lets light through, and one that cuts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at <0, 0.2, 0> right x*4/3 angle 42 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
plane { y, -2 pigment { checker rgb 0.8, rgb 0.5 } }
#default { finish { ambient 0.15 diffuse 0.7 phong 0.4 } }
sphere_sweep { linear_spline 4, <-1.2, -0.6, 0>, 0.3, <-0.4, 0.7, 0.3>, 0.2, <0.6, -0.2, -0.3>, 0.45, <1.2, 0.6, 0.2>, 0.2 translate <-1.8, 1.2, 0> pigment { rgbt <1, 0.5, 0.4, 0.5> } }
sphere_sweep { b_spline 6, <-2, -1, 0>, 0.3, <-1, 1, 0>, 0.4, <0, -1, 0.5>, 0.5, <1, 1, 0>, 0.3, <1.5, -1, -0.5>, 0.3, <2, 0, 0>, 0.1 tolerance 0.0001 translate <1.6, 1, 0> pigment { rgb <0.5, 0.9, 0.4> } }
sphere_sweep { cubic_spline, 5, <-2, 0, 0>, 0.2, <-1.4, 0.3, 0>, 0.3, <-0.4, -0.4, 0.3>, 0.4, <0.6, 0.2, 0>, 0.3, <2, 0, 0>, 0.2 translate <-1.6, -1, -1> pigment { rgb <0.6, 0.6, 1> } }
difference { box { -0.6, 0.6 } sphere_sweep { linear_spline 3, <-1, 0.2, -0.6>, 0.2, <0.1, -0.2, -0.6>, 0.3, <0.8, 0.4, -0.4>, 0.3 } rotate 20*y translate <1.6, -1.2, -1> pigment { rgb <0.9, 0.8, 0.4> } }
