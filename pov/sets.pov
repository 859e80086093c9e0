// Union, intersection, difference and merge: textures of parts and of the whole, cuts, sets in sets, one that is moved.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <1.5, 3, -7> look_at <0, 0.2, 0> right x*4/3 angle 42 }
background { rgb <0.25, 0.35, 0.45> }
light_source { <5, 8, -7>, 1 }
plane { y, -1.3 pigment { checker rgb 0.85 rgb 0.45 } finish { ambient 0.1 diffuse 0.7 } }

#declare Red = texture { pigment { rgb <0.9, 0.25, 0.15> } finish { ambient 0.1 diffuse 0.7 phong 0.4 } }
#declare Blue = texture { pigment { rgb <0.2, 0.35, 0.9> } finish { ambient 0.1 diffuse 0.6 reflection 0.2 } }

#declare Half = difference { sphere { 0, 1 } box { <-2, 0, -2>, <2, 2, 2> } }
#declare Ring = difference { torus { 0.9, 0.25 } plane { z, 0 texture { Blue } } }

difference {
    sphere { 0, 1.1 texture { Red } }
    box { <-0.3, -2, -2>, <0.3, 2, 2> texture { Blue } }
    cylinder { -2*x, 2*x, 0.45 }
    pigment { rgb <0.9, 0.9, 0.2> }
    rotate <0, 25, 10>
    translate -2.2*x
}
intersection { sphere { -0.5*x, 1 texture { Red } } sphere { 0.5*x, 1 texture { Blue } } plane { y, 0.4 } pigment { rgb 1 } }
union {
    difference { object { Half texture { Red } } cylinder { -2*y, 2*y, 0.35 } }
    object { Ring translate 0.3*y }
    merge { sphere { 1.3*y, 0.35 } box { <-0.15, 1, -0.15>, <0.15, 1.9, 0.15> } }
    pigment { rgb <0.3, 0.8, 0.3> }
    finish { ambient 0.1 diffuse 0.7 }
    rotate 20*y
    translate <2.2, -0.3, 0>
}
