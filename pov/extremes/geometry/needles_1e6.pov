// Triangles 1e6 times as long as wide.
#version 3.7;
#declare Aspect = 1e6;
#include "needles.inc"
