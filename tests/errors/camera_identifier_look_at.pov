#version 3.7;
global_settings { assumed_gamma 1 }
#declare View = camera { location -5*z }
camera { View look_at 0 }
