// Lamps 1e-3 above a plane and a sphere; what lies on the plane is lit at as small an angle.
#version 3.7;
#declare Gap = 1e-3;
#declare Near = 0.5/Gap;
#include "touching.inc"
