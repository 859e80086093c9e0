// A still life of size 1e9.
#version 3.7;
#declare Size = 1e9;
#declare Place = <0, 0, 0>;
#include "still_life.inc"
