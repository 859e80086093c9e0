#version 3.7;
global_settings { assumed_gamma 1 }
//!raytrace: shading=povray
//! Raytrace: shading=povray
//! raytrace shading=povray
//! raytrace : shading=povray
// raytrace: precision=exact
/// ! raytracer: precision=exact
// raytrace renders this scene; raytrace: a program
//! A raytraced sphere, raytrace=no
//! raytrace the sphere
sphere { 0, 1
  pigment { rgb 1 //!RAYTRACE:D=ggx
  }
}
