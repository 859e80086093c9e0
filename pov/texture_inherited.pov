// What a declared pigment or normal hands on when its pattern is stated anew: its map, wave, frequency and motion, not its numbers. And
// textures that begin with the names of declared parts; vectors as colours of cells; amounts behind the names of normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 6*y }
light_source { <-30, 40, -60>, 1 parallel point_at 0 }
#default { finish { ambient 0.2 diffuse 0.7 } }
#declare Ramp = pigment { gradient x sine_wave frequency 3 phase 0.2 color_map { [0 rgb <1, 0.8, 0.3>] [1 rgb <0.1, 0.2, 0.6>] } scale 0.4 }
#declare Deep = pigment { marble pigment_map { [0 Ramp] [0.5 checker rgb 1, rgb 0 scale 0.1] } turbulence 0.4 scale 0.3 }
#declare Board = pigment { checker rgb <0.9, 0.3, 0.2>, rgb <0.2, 0.6, 0.4> scale 0.2 }
#declare Rough = normal { bumps 0.6 scale 0.1 }
#declare Carved = normal { gradient x 1 frequency 2 slope_map { [0 <0, 1>] [1 <1, 0>] } scale 0.3 }
#declare Mixed = normal { gradient x normal_map { [0 bumps 1 scale 0.1] [1 dents 1 scale 0.1] } scale 0.5 }
#declare Shiny = finish { ambient 0.1 diffuse 0.5 phong 1 }
#declare Violet = <0.6, 0.2, 0.8>;
#declare Clear = <0.6, 0.9, 1, 0, 0.5>;
#declare Parts = texture { Board Shiny Rough }
#declare Place = array[30] {
    texture { Ramp }, texture { Board Shiny }, texture { Shiny Rough Board }, texture { Ramp Rough scale 0.5 }, texture { Parts Ramp },
    texture { pigment { Ramp bozo } }, texture { pigment { Ramp wood } }, texture { pigment { Ramp hexagon } },
    texture { pigment { Board gradient x } }, texture { pigment { Board granite frequency 1 } },
    texture { pigment { Deep onion } }, texture { pigment { Deep leopard scale 0.5 } }, texture { pigment { Deep square } },
    texture { pigment { Board rgb 1 } }, texture { pigment { Ramp color_map { [0 rgb 1] [1 rgb x] } } },
    texture { pigment { checker Violet, <0, 0.5, 0.3> scale 0.2 } }, texture { pigment { hexagon Clear, <1, 1, 0, 0, 0.3> + 0.1, 0.2 scale 0.2 } },
    texture { pigment { Clear } }, texture { pigment { rgb Violet filter 0.3 } }, texture { pigment { brick Clear, Violet scale 0.04 } },
    texture { pigment { rgb 1 } normal { Rough 2 } }, texture { pigment { rgb 1 } normal { Rough, 1.5 scale 2 } },
    texture { pigment { rgb 1 } normal { Rough dents 1 } }, texture { pigment { rgb 1 } normal { Carved onion } },
    texture { pigment { rgb 1 } normal { Carved bozo 1 } },
    texture { pigment { rgb 1 } normal { Mixed onion 1 } }, texture { pigment { rgb 1 } normal { Mixed checker scale 0.3 } },
    texture { pigment { rgb 1 } normal { Mixed 3 } }, texture { pigment { rgb 1 } normal { Mixed dents } },
    texture { pigment { rgb 1 } normal { Carved ripples 0.5 scale 0.3 } }
}
#for (I, 0, 29)
    sphere { 0, 0.45 texture { Place[I] } translate <-3 + 1.2 * mod(I, 6), 2.2 - 1.1 * div(I, 6), 0> }
#end
plane { z, 1 pigment { checker rgb 0.3, rgb 0.5 scale 0.5 } }
