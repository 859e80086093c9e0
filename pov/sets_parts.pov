// What of a set's parts counts: sheets, flags, textures of what is cut, a merge that an inverse made, parts that are clipped.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }

camera { location <1.5, 3, -7> look_at <0, 0.2, 0> right x*4/3 angle 42 }
background { rgb <0.25, 0.35, 0.45> }
light_source { <5, 8, -7>, 1 }
plane { y, -1.3 pigment { checker rgb 0.85 rgb 0.45 } finish { ambient 0.1 diffuse 0.7 reflection 0.2 } }

#declare Red = texture { pigment { rgb <0.9, 0.25, 0.15> } finish { ambient 0.1 diffuse 0.7 phong 0.4 } }
#declare Blue = texture { pigment { rgb <0.2, 0.35, 0.9> } finish { ambient 0.1 diffuse 0.6 } }
#declare Glass = texture { pigment { rgbf <0.9, 0.95, 1, 0.85> } finish { ambient 0 diffuse 0.2 phong 0.5 } }

// Of a sheet the piece inside of the other part is left, of the other part nothing.
intersection {
    sphere { 0, 1 }
    polygon { 5, <-2, -2>, <2, -2>, <2, 2>, <-2, 2>, <-2, -2> rotate <50, 20, 0> }
    texture { Red }
    translate <-2.6, 0.8, 1>
}
// An inverted intersection is a merge: of its parts' surfaces none is seen that is inside of another part.
intersection {
    box { -0.75, 0.75 }
    intersection { plane { x, 0.3 inverse } plane { y, 0.2 inverse } sphere { <0.5, 0.5, -0.3>, 0.7 } inverse }
    texture { Glass }
    interior { ior 1.2 }
    rotate <0, 30, 0>
    translate <-0.9, -0.3, -0.5>
}
// Flags of single parts count where the parts are tested one by one.
union { sphere { 0, 0.45 no_image } box { <-0.6, -0.6, 0.2>, <0.6, 0.6, 0.3> no_shadow } texture { Blue } translate <0.7, 1.4, 1> }
intersection { sphere { 0, 0.6 no_image } box { -0.45, 0.45 no_shadow } texture { Blue } translate <2.4, 1.2, 1> }
// The cut has the texture of what is cut.
difference { box { -0.6, 0.6 texture { Red } } sphere { <0.3, 0.5, -0.6>, 0.6 } cutaway_textures rotate 25*y translate <1, -0.6, -0.8> }
// What is clipped stays open, turned inside out as well, and a bound may say by what.
difference {
    sphere { 0, 0.8 }
    cylinder { -2*z, 2*z, 0.3 }
    bounded_by { plane { y - z, 0.4 } }
    clipped_by { bounded_by }
    texture { Red }
    interior_texture { Blue }
    inverse
    translate <2.7, -0.3, -0.5>
}
