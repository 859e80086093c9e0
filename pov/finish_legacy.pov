// ior, refraction and caustics written into the finish, as old scenes do (POV-Ray warns, and obeys).
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }

sphere { <-1.4, 0, 0>, 1.1 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 refraction 1 ior 1.4 phong 0.7 } }
sphere { <1.4, 0, 0>, 1.1 pigment { rgbt <0.9, 1, 0.9, 0.8> } finish { ambient 0 diffuse 0.1 refraction 0.7 ior 1.2 caustics 3 } interior { ior 1.9 } }
