#version 3.7;
global_settings { assumed_gamma 1 }
mesh { triangle { 0, x, 2*x } }
