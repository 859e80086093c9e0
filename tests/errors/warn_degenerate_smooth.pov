#version 3.7;
global_settings { assumed_gamma 1 }
smooth_triangle { 0, z, x, z, y, -z }
