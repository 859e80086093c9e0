// cutaway_textures where several textures are cut: at each point those of the parts that contain it, in equal shares.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 3.5, -8> look_at <0, 0, 0> right x*4/3 angle 42 }
background { rgb <0.25, 0.35, 0.45> }
light_source { <5, 8, -9>, 1 }
#default { pigment { rgb 0.4 } finish { ambient 0.2 diffuse 0.7 } }
#declare Red = texture { pigment { rgb <0.9, 0.25, 0.15> } finish { ambient 0.2 diffuse 0.7 phong 0.4 } }
#declare Squares = texture { pigment { checker rgb <0.2, 0.35, 0.9>, rgb 0.9 scale 0.25 } }
#declare Glass = texture { pigment { rgbf <0.7, 0.95, 0.8, 0.8> } }
#declare Mirror = texture { pigment { rgb <0.9, 0.8, 0.2> } finish { reflection 0.3 } }
plane { y, -1.3 pigment { checker rgb 0.85, rgb 0.45 } }
// The parts of a union, the last one of which has the default texture.
difference {
    union { sphere { <-0.5, 0, 0>, 0.9 texture { Red } } sphere { <0.4, 0, 0>, 0.9 texture { Squares } } cylinder { -1.1*y, 1.1*y, 0.3 } }
    plane { z, -0.3 rotate 20*x }
    cutaway_textures
    rotate 20*y
    translate <-2, 0.2, 0>
}
// What is taken away does not show, nor does a part that is elsewhere; what is inverse does.
difference {
    intersection { sphere { 0, 1 texture { Red } } box { -0.8, 0.8 texture { Mirror } } sphere { <0.9, 0, 0>, 0.6 inverse texture { Squares } } }
    sphere { <-0.4, 0.5, -0.9>, 0.6 }
    cylinder { <0.2, -0.3, -2>, <0.2, -0.3, 2>, 0.25 texture { Glass } }
    cutaway_textures
    rotate -15*y
    translate <0.4, -0.2, 0>
}
// A set in a union in an intersection. Planes contain their surfaces; of other shapes POV-Ray shows what rounding makes of it.
intersection {
    sphere { <0, 0, 0>, 1.1 texture { Glass } }
    union {
        intersection { plane { -z, 0.2 } plane { y, 0.4 } sphere { <-0.3, 0, 0>, 1 texture { Red } } }
        sphere { <0.7, 0.1, 0.2>, 0.7 texture { Squares } }
    }
    cutaway_textures
    interior { ior 1.1 }
    translate <2.5, 0, 0>
}
