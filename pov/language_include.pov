// An include file of our own, found beside the scene, included twice, and POV-Ray's colors.inc.
#version 3.7;
global_settings { assumed_gamma 1 }

#include "palette.inc"
#include "colors.inc"
#include "palette.inc"
camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

background { color SkyBlue * 0.6 }
plane { y, -1 pigment { checker color Slate color White * 0.8 } finish { Satin } }
sphere { <-1.8, 0, 0>, 1 pigment { color Brick } finish { Satin } }
sphere { <0.3, -0.2, 0>, 0.8 pigment { color Moss } finish { Satin } }
sphere { <2.1, -0.1, 0>, 0.9 pigment { Gold } finish { Satin metallic } }
