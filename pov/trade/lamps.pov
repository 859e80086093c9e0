// Two area lamps and a spot among posts: soft shadows, where most of the work is rays to lamps.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.4, -6.4> look_at <0, 0.5, 0.2> right x*4/3 angle 46 }
background { rgb <0.05, 0.06, 0.1> }
light_source { <3, 4, -3>, rgb <0.75, 0.62, 0.5> area_light <1.4, 0, 0>, <0, 0, 1.4>, 6, 6 circular orient }
light_source { <-4, 2.5, -2>, rgb <0.2, 0.3, 0.55> area_light <0, 1, 0>, <0, 0, 1>, 4, 4 }
light_source { <0, 6, 3>, rgb <0.5, 0.15, 0.1> spotlight point_at <0, 0, 1> radius 14 falloff 24 tightness 3 }

#declare Dull = finish { ambient 0.03 diffuse 0.8 }
plane { y, 0 pigment { rgb 0.7 } finish { Dull } }
plane { -z, -5 pigment { rgb <0.7, 0.72, 0.75> } finish { Dull } }
#declare Post = cylinder { 0, 1.5*y, 0.22 }
object { Post translate <-2.4, 0, 0.5> pigment { rgb <0.8, 0.5, 0.3> } finish { Dull } }
object { Post translate <-1.2, 0, -0.3> pigment { rgb <0.7, 0.7, 0.3> } finish { Dull } }
object { Post translate <0, 0, 0.5> pigment { rgb <0.4, 0.7, 0.4> } finish { Dull } }
object { Post translate <1.2, 0, -0.3> pigment { rgb <0.3, 0.6, 0.7> } finish { Dull } }
object { Post translate <2.4, 0, 0.5> pigment { rgb <0.5, 0.4, 0.7> } finish { Dull } }
torus { 0.6, 0.18 translate <0, 0.18, -1.6> pigment { rgb <0.8, 0.8, 0.75> } finish { Dull } }
