// A mesh of triangles and smooth triangles written out, with a texture of its own and no inside; light shines through its open bottom.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

mesh {
    triangle { <-1, -1, -1>, <1, -1, -1>, <0, 1.2, 0> }
    triangle { <1, -1, -1>, <1, -1, 1>, <0, 1.2, 0> }
    smooth_triangle { <1, -1, 1>, <1, 0.4, 1>, <-1, -1, 1>, <-1, 0.4, 1>, <0, 1.2, 0>, <0, 1, 0> }
    smooth_triangle { <-1, -1, 1>, <-1, 0.4, 1>, <-1, -1, -1>, <-1, 0.4, -1>, <0, 1.2, 0>, <0, 1, 0> }
    rotate 35*y
    texture { pigment { rgb <0.8, 0.7, 0.3> } finish { ambient 0.1 diffuse 0.6 phong 0.4 phong_size 15 } }
}
