// Positions, sizes and colours from expressions: vectors, functions, components, promotion, precedence.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

#declare R = 0.35 + sqrt(2) / 8;
#declare Step = vnormalize(<1, 0.4, -0.2>) * 1.5;
#declare Start = -<2.2, 0.6, 0>;
#declare Spin = degrees(pi / 6);
#declare Tint = rgb <0.9, 0.5, 0.2>;
sphere { Start, R pigment { color Tint } }
sphere { Start + Step, R * (1 + 1 = 2) pigment { rgb <sin(1), abs(-0.3), mod(7.4, 1)> } }
sphere { Start + 2 * Step, select(-1, 0.3, 0.5, 0.9) pigment { rgb vlength(<0.3, 0.4, 0>) * <1, 1.5, 2> / 2 } }
box { -0.4, <0.4, pow(2, -1), 0.4> rotate Spin * y translate <1.6, -0.6, -1.4> pigment { rgb <Tint.blue, Tint.red, (3 > 2 ? 0.4 : 0.9)> } }
cylinder { vrotate(<0, -0.6, 0>, <0, 0, 30>), vaxis_rotate(<0, 0.6, 0>, z, 30), min(0.2, 0.3) translate <-0.6, -0.2, -2> pigment { rgb <0.3, 0.4, max(0.2, 0.8)> } }
