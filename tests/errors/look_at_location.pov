#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, 3> look_at <1, 2, 3> }
