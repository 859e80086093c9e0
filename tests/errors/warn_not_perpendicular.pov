#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z up <0.1, 1, 0> }
sphere { 0, 1 }
