// Waves, frequency and phase of patterns of cells: what their map of 0, 1, 2 ... is asked with. One kind a row, one wave a column, and at
// the bottom cells of pigments, textures and normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right 8.4*x up 6.3*y }
light_source { <-30, 40, -60>, 1 parallel point_at 0 }
#default { finish { ambient 0.2 diffuse 0.7 } }
#declare Light = rgb <1, 0.9, 0.6>;
#declare Dark = rgb <0.1, 0.2, 0.5>;
#declare Wave = array[6] {
    pigment { gradient x frequency 1 }
    pigment { gradient x frequency 0 sine_wave }
    pigment { gradient x frequency 0.4 phase 0.3 }
    pigment { gradient x frequency 2 triangle_wave phase 0.2 }
    pigment { gradient x frequency -1 cubic_wave }
    pigment { gradient x frequency 0.7 scallop_wave }
}
#macro Tile(Column, Row, What)
    box { <-0.6, -0.45, 0>, <0.6, 0.45, 1> texture { What } translate <-3.25 + 1.3*Column, 2.5 - Row, 0> }
#end
// A list of colours states the frequency 0 anew; phase and wave stay with the declared pigment.
#for (C, 0, 5)
    Tile(C, 0, pigment { Wave[C] checker Light, Dark scale 0.2 })
    Tile(C, 1, pigment { Wave[C] hexagon Light, Dark, rgb x scale 0.2 })
    Tile(C, 2, pigment { Wave[C] cubic scale 0.2 frequency 0.15 * (C + 1) })
    Tile(C, 3, pigment { brick frequency 0.2 * C phase 0.1 * C scale 0.04 })
    Tile(C, 4, pigment { triangular frequency 0.1 * C sine_wave scale 0.2 })
#end
Tile(0, 5, texture { hexagon texture { pigment { Light } finish { ambient 0.6 } } texture { pigment { Dark } } texture { pigment { granite } } frequency 0.4 phase 0.1 scale 0.2 })
Tile(1, 5, texture { checker texture { pigment { Light } } texture { pigment { Dark } finish { phong 1 } } sine_wave frequency 0.3 scale 0.2 })
Tile(2, 5, pigment { square pigment { bozo scale 0.1 } pigment { Light } pigment { Dark } frequency 0.2 scale 0.2 })
Tile(3, 5, texture { pigment { rgb 1 } normal { hexagon normal { bumps 1 scale 0.1 } normal { dents 1 scale 0.1 } normal { granite 0.4 scale 0.3 } frequency 0.4 scale 0.2 } })
Tile(4, 5, texture { pigment { rgb 1 } normal { cubic 1 frequency 0.3 sine_wave scale 0.2 } })
Tile(5, 5, pigment { pigment_pattern { hexagon rgb 0, rgb 0.5, rgb 1 phase 0.2 frequency 0.3 } color_map { [0 Light] [1 Dark] } scale 0.2 })
