#version 3.7;
global_settings { assumed_gamma 1 }
#declare View = camera { look_at <0, 0, -5>
  location <0, 0, -5> }
camera { View rotate 20*y }
