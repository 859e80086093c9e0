// Glass as sets: parts with one interior, surfaces inside that a union shows and a merge does not, a camera in none of them.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }

camera { location <1.5, 3, -7> look_at <0, 0.2, 0> right x*4/3 angle 42 }
background { rgb <0.25, 0.35, 0.45> }
light_source { <5, 8, -7>, 1 }
plane { y, -1.3 pigment { checker rgb 0.85 rgb 0.45 } finish { ambient 0.1 diffuse 0.7 } }

#declare Red = texture { pigment { rgb <0.9, 0.25, 0.15> } finish { ambient 0.1 diffuse 0.7 phong 0.4 } }
#declare Blue = texture { pigment { rgb <0.2, 0.35, 0.9> } finish { ambient 0.1 diffuse 0.6 reflection 0.2 } }

#declare Glass = finish { ambient 0 diffuse 0.1 phong 0.5 reflection 0.05 }
#declare Pair = union { sphere { -0.5*x, 0.8 } sphere { 0.5*x, 0.8 } }

object { Pair pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { Glass } interior { ior 1.3 } translate -2.3*x }
merge { sphere { -0.5*x, 0.8 } sphere { 0.5*x, 0.8 } cylinder { -0.9*y, 1.2*y, 0.4 } pigment { rgbf <0.95, 1, 0.9, 0.9> } finish { Glass } interior { ior 1.3 } }
difference {
    box { -0.9, 0.9 }
    sphere { <0.5, 0.6, -0.7>, 0.9 }
    pigment { rgbf <1, 0.95, 0.9, 0.9> }
    finish { Glass }
    interior { ior 1.4 fade_distance 2 fade_power 1 }
    rotate 20*y
    translate 2.4*x
}
