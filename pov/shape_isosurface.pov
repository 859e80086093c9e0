// Isosurfaces: closed and open, in a box and in a ball, moved, cut by other shapes, transparent, and of noise and patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 42 }
light_source { <5, 9, -7>, rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.5 } }
isosurface {
  function { pow(x, 4) + pow(y, 4) + pow(z, 4) - 0.8 }
  max_gradient 8
  pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.6 }
  rotate 30*y translate <-2.8, 0, 1>
}
isosurface {
  function { x*x + z*z - 0.3 - 0.2*sin(9*y) }
  contained_by { sphere { 0, 1.1 } }
  max_gradient 6 open
  pigment { rgb <0.3, 0.7, 0.3> }
  rotate <20, 0, 10> scale <1, 1.2, 1> translate <0, 0.2, 1>
}
difference {
  isosurface {
    function { f_r(x, y, z) - 0.9 - 0.4*f_noise3d(4*x, 4*y, 4*z) }
    contained_by { box { -1.4, 1.4 } }
    threshold 0.05 max_gradient 3 accuracy 0.002 all_intersections
  }
  box { <0, 0, -2>, 2 }
  pigment { rgb <0.3, 0.4, 0.9> }
  translate <2.8, 0.2, 1>
}
isosurface {
  function { f_torus(x, y, z, 0.6, 0.25) }
  contained_by { box { <-1, -0.3, -1>, <1, 0.3, 1> } }
  accuracy 0.0005 max_gradient 1.5
  pigment { rgbf <0.6, 0.8, 1, 0.8> } no_shadow
  rotate -30*x translate <-1.2, -0.3, -2>
}
#declare Cracks = function { pattern { crackle scale 0.4 } }
isosurface {
  function { y + 0.2 - 0.3*Cracks(x, 0, z) }
  contained_by { box { <-0.8, -0.5, -0.6>, <0.8, 0.3, 0.6> } }
  max_gradient 3
  pigment { rgb <0.8, 0.7, 0.4> }
  translate <1.2, -0.5, -2>
}
