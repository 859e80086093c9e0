// A still life of size 1e6.
#version 3.7;
#declare Size = 1e6;
#declare Place = <0, 0, 0>;
#include "still_life.inc"
