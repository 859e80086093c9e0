#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <1e300, 0, 0> * 1e300, rgb 1 }
