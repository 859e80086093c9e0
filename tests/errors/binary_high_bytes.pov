#version 3.7;
sphere { ÿþ0, 1 }
