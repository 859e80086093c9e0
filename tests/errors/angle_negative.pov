#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle -20 }
