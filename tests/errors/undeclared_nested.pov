#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1
  texture { pigment { checker rgb 1 rgb Grey scale 2 } }
}
