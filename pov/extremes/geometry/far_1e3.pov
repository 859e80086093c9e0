// A still life of size 1 at 1e3 from the origin.
#version 3.7;
#declare Size = 1;
#declare Place = 1e3*<1, 0.6, -0.8>;
#include "still_life.inc"
