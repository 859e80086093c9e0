// As LeoCAD writes: lamps without shadows, colours declared as textures in sRGB, parts as unions of meshes placed by matrices, a macro that
// is declared unless the user has one.
// Stud.io: none
#version 3.7;

global_settings { assumed_gamma 1.0 }

#declare part_quality = 3;
#ifndef (part_finish)
#macro part_finish(FINISH)
  #if (part_quality > 2)
    finish { ambient 0.2 diffuse FINISH reflection { 0.08 } phong 0.5 phong_size 40 }
  #elseif (part_quality > 1)
    finish { ambient 0.3 diffuse FINISH }
  #else
    finish { ambient 1 diffuse 0 }
  #end
#end
#end

camera {
  perspective
  right x * 4 / 3
  sky<0,0,1>
  location <-6, -7.5, 5>
  look_at <0, 0, 0.4>
  angle 40
}

background { color srgb <0.75, 0.8, 0.85> }

light_source{ <-10, -20, 30> color rgb <0.8, 0.8, 0.8> shadowless }
light_source{ <20, -10, 40> color rgb <0.6, 0.6, 0.6> fade_distance 30 fade_power 2 spotlight radius 20 falloff 35 point_at <0, 0, 0> }

#declare color_red = texture { pigment { srgb <0.78, 0.1, 0.04> } part_finish(0.8) }
#declare color_clear = texture { pigment { srgbf <0.4, 0.7, 0.9, 0.6> } finish { ambient 0.1 diffuse 0.4 reflection { 0.1 } } }

#declare part_wedge = union {
  mesh {
    triangle { <-1.0, -1.0, 0.0>, <1.0, -1.0, 0.0>, <1.0, 1.0, 0.0> }
    triangle { <-1.0, -1.0, 0.0>, <1.0, 1.0, 0.0>, <-1.0, 1.0, 0.0> }
    triangle { <-1.0, -1.0, 0.0>, <1.0, -1.0, 0.0>, <1.0, 0.0, 1.2> }
    triangle { <-1.0, -1.0, 0.0>, <1.0, 0.0, 1.2>, <-1.0, 0.0, 1.2> }
    triangle { <-1.0, 1.0, 0.0>, <1.0, 0.0, 1.2>, <1.0, 1.0, 0.0> }
    triangle { <-1.0, 1.0, 0.0>, <-1.0, 0.0, 1.2>, <1.0, 0.0, 1.2> }
    triangle { <-1.0, -1.0, 0.0>, <-1.0, 0.0, 1.2>, <-1.0, 1.0, 0.0> }
    triangle { <1.0, -1.0, 0.0>, <1.0, 1.0, 0.0>, <1.0, 0.0, 1.2> }
  }
  mesh {
    smooth_triangle { <-0.5, 0.0, 1.5>, <-0.3, 0.0, 0.9>, <0.0, -0.5, 1.2>, <0.0, -0.5, 0.8>, <0.0, 0.0, 1.9>, <0.0, 0.0, 1.0> }
    smooth_triangle { <0.0, -0.5, 1.2>, <0.0, -0.5, 0.8>, <0.5, 0.0, 1.5>, <0.3, 0.0, 0.9>, <0.0, 0.0, 1.9>, <0.0, 0.0, 1.0> }
    texture { color_clear }
  }
}

object {
  part_wedge
  texture { color_red }
  matrix <0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0, -1.2, 0.0, 0.0>
}
object {
  part_wedge
  texture { color_clear normal { bumps 0.05 scale 0.1 } }
  interior { ior 1.25 }
  matrix <1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.6, -0.3, 0.1>
}
