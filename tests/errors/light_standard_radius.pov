#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <4, 6, -5>, rgb 1 radius 10 }
