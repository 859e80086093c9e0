// Index 1e6: almost everything is reflected.
#version 3.7;
#declare Index = 1e6;
#declare Lamp = 2;
#include "index.inc"
