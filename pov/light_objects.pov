// Lights that are seen, lights through masks, and lights of groups.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -8> look_at <0, 0.3, 0> right x*4/3 angle 45 }
#default { finish { ambient 0.1 diffuse 0.7 } }
light_source { <4, 6, -5>, rgb 0.4 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.7 } }
#declare Lamp = light_source {
  0, rgb <0.6, 0.5, 0.2>
  looks_like { union { sphere { 0, 0.2 } cylinder { 0, 0.5*y, 0.05 pigment { rgb <0.3, 0.3, 0.6> } } } pigment { rgb <1, 1, 0.5> } finish { emission 0.8 } }
  fade_distance 2 fade_power 2
}
object { Lamp translate <-1.6, 1.2, 0> }
light_source { <1.2, 3, 0>, rgb <0.6, 0.3, 0.6> projected_through { difference { box { <0.4, 1.5, -0.8>, <2, 1.6, 0.8> } cylinder { <1.2, 1, 0>, <1.2, 2, 0>, 0.35 } } } }
box { <1.4, 0.2, -0.2>, <1.8, 0.3, 0.3> pigment { rgb <0.4, 0.6, 1> } }
box { <0.4, 2.2, -0.2>, <0.8, 2.3, 0.3> pigment { rgb <0.4, 0.6, 1> } }
light_group {
  light_source { <-3, 4, -4>, rgb <0.2, 0.8, 0.3> }
  sphere { <-2.6, -0.3, -0.5>, 0.6 pigment { rgb 1 } }
  light_group { light_source { <1, 2, -4>, rgb <0.8, 0.2, 0.2> } sphere { <-0.9, -0.4, -1>, 0.5 pigment { rgb 1 } } global_lights on }
  global_lights on
}
light_group { sphere { <0.3, -0.5, -1.6>, 0.4 pigment { rgb 1 } } light_source { <4, 2, -4>, rgb 0.6 } }
