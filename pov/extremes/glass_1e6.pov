// A sphere of index 1e6: a mirror.
#version 3.7;
#declare Index = 1e6;
#include "glass.inc"
