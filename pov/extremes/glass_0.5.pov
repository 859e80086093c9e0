// A sphere of index 0.5: a bubble of a thinner medium, with total reflection outside.
#version 3.7;
#declare Index = 0.5;
#include "glass.inc"
