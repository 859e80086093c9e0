// As ASE writes: finishes declared without a semicolon, right before up and before the location, macros of a finish's name, a torus pair.
#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White}
camera {orthographic
  right -8.00*x up 6.00*y
  direction 1.00*z
  location <0,0,50.00> look_at <0,0,0>}
light_source {<  2.00,   3.00,  40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1}
// no fog
#declare simple = finish {phong 0.7}
#declare pale = finish {ambient 0.5 diffuse 0.85 roughness 0.001 specular 0.200 }
#declare glassy = finish {ambient 0.05 diffuse 0.3 specular 1.0 roughness 0.001 reflection 0.1}
#declare Rcell = 0.050;
#declare Rbond = 0.100;

#macro ball(LOC, R, COL, TRANS, FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro held(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
      torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
      translate LOC}
#end

cylinder {< -3.00,  -2.00,  -4.00>, <  3.00,  -2.00,  -4.00>, Rcell pigment {Black}}
cylinder {< -3.00,  -2.00,  -4.00>, < -3.00,   2.00,  -4.00>, Rcell pigment {Black}}
ball(< -1.22,  -0.61,  -2.06>, 1.09, rgb <0.78, 0.50, 0.20>, 0.0, simple) // #0
ball(<  1.02,   0.65,  -2.50>, 0.86, rgb <0.30, 0.40, 0.90>, 0.2, pale) // #1
ball(<  0.40,  -1.10,  -0.90>, 0.50, White, 0.0, glassy) // #2
cylinder {< -1.22,  -0.61,  -2.06>, <1.02, 0.65, -2.50>, Rbond texture{pigment {color rgb <0.5, 0.5, 0.5> transmit 0.0} finish{simple}}}
held(<  1.02,   0.65,  -2.50>, 1.00, Black, 0.0 simple)
