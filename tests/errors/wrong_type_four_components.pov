#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <1, 2, 3, 4>, rgb 1 }
