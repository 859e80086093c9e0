// Index 1 + 1e-6: 2.5e-13 of the light is reflected at normal incidence.
#version 3.7;
#declare Index = 1 + 1e-6;
#declare Lamp = 4e12;
#include "index.inc"
