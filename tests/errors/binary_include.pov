#version 3.7;
#include "inc/binary.inc"
