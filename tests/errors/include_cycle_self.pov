#version 3.7;
#include "include_cycle_self.pov"
