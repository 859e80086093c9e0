// Layered textures: a clear coat over a filtered glaze over an opaque base; reflections of all layers add up.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
background { rgb <0.5, 0.65, 0.9> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb <0.4, 0.2, 0.15> } }
light_source { <5, 8, -6>, rgb 1 }

#declare Base = texture { pigment { checker rgb <0.8, 0.3, 0.1> rgb <0.9, 0.8, 0.5> scale 0.4 } finish { ambient 0.1 diffuse 0.7 } }
sphere { <-1.4, 0.3, 0>, 1.2 texture { Base } texture { pigment { rgbt <0.1, 0.3, 0.9, 0.5> } finish { phong 0.8 reflection 0.2 } } }
box { -1, 1 rotate <20, 35, 0> translate <1.5, 0.2, 0>
    texture { Base }
    texture { pigment { rgbf <0.5, 0.9, 0.6, 0.8> } finish { ambient 0 diffuse 0.2 } }
    texture { pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.3 specular 0.8 roughness 0.02 } }
}
