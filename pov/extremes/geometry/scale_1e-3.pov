// A still life of size 1e-3.
#version 3.7;
#declare Size = 1e-3;
#declare Place = <0, 0, 0>;
#include "still_life.inc"
