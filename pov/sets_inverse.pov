// Inverse, clipped_by and bounded_by, of single objects and of sets; flags that parts have from the whole; a lamp in a union.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <1.5, 3, -7> look_at <0, 0.2, 0> right x*4/3 angle 42 }
background { rgb <0.25, 0.35, 0.45> }
light_source { <5, 8, -7>, 1 }
plane { y, -1.3 pigment { checker rgb 0.85 rgb 0.45 } finish { ambient 0.1 diffuse 0.7 } }

#declare Red = texture { pigment { rgb <0.9, 0.25, 0.15> } finish { ambient 0.1 diffuse 0.7 phong 0.4 } }
#declare Blue = texture { pigment { rgb <0.2, 0.35, 0.9> } finish { ambient 0.1 diffuse 0.6 reflection 0.2 } }

sphere {
    0, 1
    clipped_by { plane { y, 0.3 } }
    clipped_by { box { -0.7, 3 inverse } }
    texture { Red }
    interior_texture { Blue }
    rotate <10, 30, 0>
    translate -2.3*x
}
difference {
    box { -0.8, 0.8 }
    sphere { 0, 1 }
    clipped_by { plane { x + z, 0.4 } }
    bounded_by { sphere { 0, 2 } }
    texture { Red }
    rotate 35*y
}
intersection {
    box { -0.9, 0.9 }
    union { sphere { 0.8*x, 0.8 } sphere { -0.8*x, 0.8 } inverse }
    no_shadow
    texture { Blue }
    rotate <30, 40, 0>
    translate <2.3, 0.2, 0>
}
union {
    light_source { <-3, 4, -3>, <0.4, 0.25, 0.1> }
    sphere { <-1.1, -1, -2>, 0.3 }
    intersection { plane { x, 0.3 } plane { -x, 0.3 } plane { y, 0.3 } plane { -y, 0.3 } plane { z, 0.3 } plane { -z, 0.3 } translate <1.2, -1, -2> }
    pigment { checker rgb 1 rgb <0.5, 0.1, 0.1> scale 0.2 }
    finish { ambient 0.1 diffuse 0.7 }
}
