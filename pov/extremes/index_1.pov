// Index 1: no interface: nothing is reflected by the exact terms.
#version 3.7;
#declare Index = 1;
#declare Lamp = 3e13;
#include "index.inc"
