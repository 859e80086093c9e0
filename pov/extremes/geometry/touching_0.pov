// A lamp in a plane, and one on a sphere.
#version 3.7;
#declare Gap = 0;
#declare Near = 0.8;
#include "touching.inc"
