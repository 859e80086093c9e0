// Discs with and without holes, planes as walls, and polygons: a star with a hole of even-odd contours.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

plane { <-1, 0, -2>, -3 pigment { rgb <0.7, 0.6, 0.5> } }
disc { <-2, 0.2, 0>, <0.3, 0.4, -1>, 0.9 pigment { rgb <0.9, 0.4, 0.3> } }
disc { <2, 0.2, -0.3>, <-0.5, 0.6, -1>, 1, 0.45 pigment { rgb <0.4, 0.6, 0.9> } }
polygon {
    16,
    <0, 1>, <0.25, 0.3>, <0.95, 0.3>, <0.4, -0.1>, <0.6, -0.8>, <0, -0.4>, <-0.6, -0.8>, <-0.4, -0.1>, <-0.95, 0.3>, <-0.25, 0.3>, <0, 1>,
    <-0.15, -0.1>, <0.15, -0.1>, <0.15, 0.2>, <-0.15, 0.2>, <-0.15, -0.1>
    rotate <10, 15, 0> translate <0, 0.1, -0.4> pigment { rgb <0.9, 0.8, 0.2> }
}
