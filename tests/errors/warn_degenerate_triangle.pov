#version 3.7;
global_settings { assumed_gamma 1 }
triangle { <0, 0, 0>, <1, 1, 1>, <2, 2, 2> }
