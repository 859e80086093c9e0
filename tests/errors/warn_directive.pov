#version 3.7;
global_settings { assumed_gamma 1 }
#warning "mind the gap"
sphere { 0, 1 }
