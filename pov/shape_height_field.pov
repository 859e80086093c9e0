// Height fields: of a picture, flat and smooth, with water; of a function; cut, and cutting.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.2, -6> look_at <0, 0, 0> right x*4/3 angle 46 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
#default { finish { ambient 0.15 diffuse 0.7 phong 0.4 } }
plane { y, -0.6 pigment { checker rgb 0.8, rgb 0.5 } }
height_field { png "picture.png" scale <1.8, 0.8, 1.6> rotate -20*y translate <-2.7, -0.4, 0> pigment { rgb <1, 0.6, 0.4> } }
height_field { png "picture.png" gamma 2.2 smooth water_level 0.2 scale <1.8, 0.8, 1.6> translate <-0.8, -0.4, 0.3> pigment { rgb <0.4, 0.8, 0.4> } }
height_field { function 40, 30 { 0.5 + 0.3*sin(12*x)*cos(9*y) } smooth scale <1.8, 0.6, 1.6> rotate 15*y translate <1.1, -0.4, 0> pigment { rgb <0.5, 0.6, 1> } }
difference {
  box { <-1.6, -0.4, -1.8>, <-0.1, 0.5, -0.6> pigment { rgb <0.9, 0.8, 0.3> } }
  height_field { function 12, 12 { 0.5 + 0.4*cos(9*x)*sin(7*y) } inverse scale <2, 0.9, 2> translate <-1.9, -0.4, -2.2> pigment { rgb <0.8, 0.3, 0.3> } }
}
height_field { function 8, 8 { x*y } scale <1, 0.9, 1> clipped_by { cylinder { -y, y, 0.5 translate 0.5*(x+z) } } translate <0.4, -0.4, -1.7> pigment { rgb <0.7, 0.5, 0.8> } interior_texture { pigment { rgb <1, 0.2, 0.2> } } }
