// Triangles 1e9 times as long as wide.
#version 3.7;
#declare Aspect = 1e9;
#include "needles.inc"
