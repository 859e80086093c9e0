#version 3.7;
global_settings { assumed_gamma 1 }
#default { texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } }
