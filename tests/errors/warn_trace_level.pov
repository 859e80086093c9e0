#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { max_trace_level 1000 }
sphere { 0, 1 }
