// A ball and a box in shells of glass 1e-9 apart.
#version 3.7;
#declare Gap = 1e-9;
#include "shells.inc"
