// Nothing: what every run costs.
#version 3.7;
