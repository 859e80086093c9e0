// A camera in a ball of glass, 1e-3 below its surface.
#version 3.7;
#declare Depth = 1e-3;
#include "in_glass.inc"
