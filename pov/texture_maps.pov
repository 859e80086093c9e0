// Patterns of textures: what lies between two entries is shaded with both, mirrors, bumps and shadows included.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb 0.8] [1 rgb <0.2, 0.4, 0.8>] } } }
#declare Mirror = texture { pigment { rgb 0.1 } finish { ambient 0 diffuse 0.3 reflection 0.6 } }
#declare Rough = texture { pigment { bozo color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.4>] } scale 0.2 } normal { bumps 0.6 scale 0.1 } }
#declare Coated = texture { Rough } texture { pigment { rgbt <0.2, 0.5, 0.9, 0.6> } finish { phong 0.7 } }
plane { y, -1 texture { checker texture { pigment { rgb 0.8 } } texture { Mirror } scale 0.8 } }
sphere { <-1.5, 0.2, 0>, 1.2 texture { gradient y texture_map { [0.3 Rough] [0.6 Mirror] } translate -0.2*y scale 1.5 } }
sphere { <1.5, 0.2, 0>, 1.2 texture { granite texture_map { [0.2 Coated] [0.4 pigment { rgbt <1, 1, 1, 0.8> } finish { reflection 0.2 }] } } }
box { <-0.4, -1, -2.4>, <0.4, -0.2, -1.6> texture { average texture_map { [1 Mirror] [2 Rough scale 3] } } }
