// A still life of size 1.
#version 3.7;
#declare Size = 1;
#declare Place = <0, 0, 0>;
#include "still_life.inc"
