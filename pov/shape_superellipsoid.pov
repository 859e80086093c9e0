// Superellipsoids from a cushioned box to a double cone, and bicubic patches of few and of many triangles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -10> look_at <0, 0, 0> right x*4/3 angle 46 }
background { rgb <0.2, 0.3, 0.4> }
light_source { <6, 12, -9> rgb 1 }
plane { y, -3 pigment { checker rgb 0.8, rgb 0.5 } }
#default { finish { ambient 0.15 diffuse 0.7 phong 0.4 } }
superellipsoid { <0.25, 0.25> rotate <20, 30, 0> translate <-3.4, 1.4, 0> pigment { rgb <1, 0.5, 0.4> } }
superellipsoid { <1, 0.3> rotate <60, 0, 20> translate <-1.1, 1.4, 0> pigment { rgb <0.5, 0.9, 0.4> } }
superellipsoid { <1.6, 1> rotate <20, 20, 0> translate <1.2, 1.4, 0> pigment { rgb <0.4, 0.6, 1> } }
superellipsoid { <1, 2> rotate <70, 0, 10> translate <3.6, 1.4, 0> pigment { rgb <1, 0.9, 0.3> } }
bicubic_patch {
    type 1 flatness 0 u_steps 3 v_steps 3
    <-1.5, 0, -1.5>, <-0.5, 1, -1.5>, <0.5, 0, -1.5>, <1.5, 0.5, -1.5>, <-1.5, 0, -0.5>, <-0.5, 1, -0.5>, <0.5, -1, -0.5>, <1.5, 0.3, -0.5>,
    <-1.5, 0.4, 0.5>, <-0.5, -1, 0.5>, <0.5, 1, 0.5>, <1.5, 0, 0.5>, <-1.5, 0, 1.5>, <-0.5, 0.5, 1.5>, <0.5, 0, 1.5>, <1.5, -0.5, 1.5>
    translate <-2, -1.6, -0.5> pigment { rgb <0.9, 0.5, 0.9> }
}
bicubic_patch {
    type 0 u_steps 1 v_steps 0
    <-1.5, 0, -1.5>, <-0.5, 1, -1.5>, <0.5, 0, -1.5>, <1.5, 0.5, -1.5>, <-1.5, 0, -0.5>, <-0.5, 1, -0.5>, <0.5, -1, -0.5>, <1.5, 0.3, -0.5>,
    <-1.5, 0.4, 0.5>, <-0.5, -1, 0.5>, <0.5, 1, 0.5>, <1.5, 0, 0.5>, <-1.5, 0, 1.5>, <-0.5, 0.5, 1.5>, <0.5, 0, 1.5>, <1.5, -0.5, 1.5>
    translate <2, -1.6, -0.5> pigment { rgb <0.5, 0.9, 0.9> }
}
