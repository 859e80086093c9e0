// A sphere of index 1 + 1e-6: nothing of it is seen but where it grazes.
#version 3.7;
#declare Index = 1 + 1e-6;
#include "glass.inc"
