#version 3.7;
global_settings { assumed_gamma 1 }
#include "inc/missing_brace.inc"
sphere { 0, 1 pigment { Red } }
