#version 3.7;
global_settings { assumed_gamma 1 }
#include "inc/unmodelled.inc"
sphere { 0, 1 pigment { Sky } }
