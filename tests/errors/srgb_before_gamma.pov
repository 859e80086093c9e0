#version 3.7;
background { srgb <0.5, 0.5, 1> }
