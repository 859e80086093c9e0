#version 3.7;
global_settings { assumed_gamma 1 }
#declare V = <1, 2, 3, 4, 5, 6>;
