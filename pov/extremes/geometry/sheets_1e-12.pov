// Sheets 1e-12 over a plane, seen on the left, casting their shadows unseen on the right.
#version 3.7;
#declare Gap = 1e-12;
#include "sheets.inc"
