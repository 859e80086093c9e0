// Blobs: spheres, cylinders, the old form of a component, a field that carves, moved and stretched components.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at <0, 0, 0> right x*4/3 angle 46 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
plane { y, -2.5 pigment { checker rgb 0.8, rgb 0.5 } }
#default { finish { ambient 0.15 diffuse 0.7 phong 0.4 } }
blob { threshold 0.6 sphere { <0.75, 0, 0>, 1, 1 } sphere { <-0.375, 0.65, 0>, 1, strength 1 } sphere { <-0.375, -0.65, 0>, 1 1 } sphere { <0.2, 0.2, -0.7>, 0.7, -0.9 } translate <-2.4, 1, 0> pigment { rgb <1, 0.5, 0.4> } }
blob { threshold 0.5 cylinder { <-1, -0.3, 0>, <1, 0.5, 0.2>, 0.8, 1 } sphere { <0, 0.6, -0.3>, 0.9, 0.8 } component 0.7, 0.8, <0.4, -0.7, 0> sturm translate <1.8, 1, 0> pigment { rgb <0.5, 0.9, 0.4> } }
blob { sphere { 0, 1.2, 2 scale <1.5, 0.7, 1> rotate 30*z } cylinder { -y, y, 0.6, 2 rotate 50*x translate 0.8*x } hierarchy off translate <0, -1.2, -1> pigment { rgb <0.4, 0.6, 1> } }
