// A camera in a ball of glass, 0.5 below its surface.
#version 3.7;
#declare Depth = 0.5;
#include "in_glass.inc"
