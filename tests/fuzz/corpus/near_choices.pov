#version 3.7;
//!raytrace: shading=povray
//! Raytrace: D=ggx
// raytrace: precision=exact
//! raytrace shading=povray
// raytrace
sphere { 0, 1 }
