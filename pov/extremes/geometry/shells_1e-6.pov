// A ball and a box in shells of glass 1e-6 apart.
#version 3.7;
#declare Gap = 1e-6;
#include "shells.inc"
