// Index 0.5: the exact terms reflect totally beyond 30 degrees.
#version 3.7;
#declare Index = 0.5;
#declare Lamp = 3;
#include "index.inc"
