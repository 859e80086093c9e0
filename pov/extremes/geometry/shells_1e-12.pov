// A ball and a box in shells of glass 1e-12 apart.
#version 3.7;
#declare Gap = 1e-12;
#include "shells.inc"
