sphere { 0, 1 }
#version 3.7;
global_settings { assumed_gamma 1 }
