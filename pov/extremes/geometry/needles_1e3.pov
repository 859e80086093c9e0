// Triangles 1e3 times as long as wide.
#version 3.7;
#declare Aspect = 1e3;
#include "needles.inc"
