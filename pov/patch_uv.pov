// Textures seen at the (u, v) of bicubic patches: their own, and mapped to four stated corners, a parallelogram's and others.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -9> look_at 0 right x*4/3 angle 50 }
light_source { <3, 5, -9>, 1 }
#default { finish { ambient 0.3 diffuse 0.6 } }
#macro Points()
    <-2, -2, 0>, <-0.7, -2, 1>, <0.7, -2, 0>, <2, -2, 0.5>,
    <-2, -0.7, 0.4>, <-0.7, -0.7, -1>, <0.7, -0.7, 0>, <2, -0.7, 0>,
    <-2, 0.7, 0>, <-0.7, 0.7, 1>, <0.7, 0.7, -1>, <2, 0.7, 0>,
    <-2, 2, 0>, <-0.7, 2, 0.3>, <0.7, 2, 0>, <2, 2.3, 0>
#end
#declare Board = texture { uv_mapping pigment { checker rgb <1, 0.8, 0.3>, rgb <0.1, 0.2, 0.6> scale <0.2, 0.1, 1> } }
#declare Slope = texture {
    pigment { uv_mapping gradient <1, 2, 0> color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.1, 0.7, 0.9>] } }
    finish { phong 0.5 }
}
#declare Size = transform { scale 0.6 }
bicubic_patch { type 1 u_steps 4 v_steps 3 Points() texture { Board } transform { Size } translate <-3, 1.5, 0> }
bicubic_patch { type 0 flatness 0.05 u_steps 4 v_steps 4 Points() texture { Slope } transform { Size } translate <0, 1.5, 0> }
bicubic_patch {
    type 1 u_steps 1 v_steps 0 uv_vectors <0, 1>, <0, 0>, <1, 0>, <1, 1> Points() texture { Slope } transform { Size } translate <3, 1.5, 0>
}
bicubic_patch {
    type 1 u_steps 3 v_steps 3 uv_vectors <0, 0>, <2, 0>, <2.5, 1>, <0.5, 1> Points() texture { Board } transform { Size } translate <-3, -1.5, 0>
}
bicubic_patch {
    type 1 u_steps 0 v_steps 0 uv_vectors <0, 0>, <2, 0>, <1, 1>, <0.3, 1.5> Points() texture { Board } transform { Size } translate <0, -1.5, 0>
}
bicubic_patch {
    type 1 u_steps 3 v_steps 2 uv_vectors <0, 0>, <2, 0>, <1, 1>, <0.3, 1.5> Points() texture { Slope } transform { Size } translate <3, -1.5, 0>
}
