// A declared camera, turned and moved by transforms after it was aimed; a transform identifier inverted.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Turn = transform { rotate <10, -35, 5> translate <0.3, 0.2, 0> }
#declare View = camera { location <0, 1, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
camera { View transform { Turn } rotate 15*y transform { Turn inverse } }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

sphere { <-1.6, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.2> } finish { specular 0.4 } }
box { <-0.4, -1, -0.6>, <0.8, 0.6, 0.6> pigment { rgb <0.3, 0.7, 0.3> } rotate 20*y }
cone { <2.1, -1, 0>, 0.9, <2.1, 1.2, 0>, 0.1 pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.6 } }
