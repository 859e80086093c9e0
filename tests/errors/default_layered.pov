#version 3.7;
global_settings { assumed_gamma 1 }
#declare Stained = texture { pigment { rgb 1 } } texture { pigment { rgbt 0.5 } }
#default {
  texture { Stained }
}
