// Cones and a cylinder on a tilted board, three lamps of other colours; by the course's rules.
camera { location <3, 4, 9> up <0, 1, 0> right <1.3333, 0, 0> look_at <0.3, 0.2, 0> }
light_source { <8, 10, 4> color rgb <1.1, 0.6, 0.3> }
light_source { <-7, 5, 6> color rgb <0.2, 0.5, 0.7> }
light_source { <1, 3, -6> color rgb <0.4, 0.4, 0.1> }
box { <-4, -0.3, -3>, <4, 0, 3>
  pigment { color rgb <0.55, 0.35, 0.2> } finish { ambient 0.15 diffuse 0.8 specular 0.25 roughness 0.3 } rotate <9, 20, -6> }
cone { <-1.8, 0.2, 0.4>, 0.9, <-1.8, 2.1, 0.4>, 0.1
  pigment { color rgb <0.9, 0.2, 0.3> } finish { ambient 0.1 diffuse 0.6 specular 0.8 roughness 0.15 } scale <1, 1.2, 0.7> }
cylinder { <0.6, 0.1, -0.8>, <1.1, 2.4, -1.1>, 0.6
  pigment { color rgb <0.2, 0.8, 0.5> } finish { ambient 0.2 diffuse 0.5 specular 0.6 roughness 0.2 reflection 0.3 } }
sphere { <0, 0, 0>, 1
  pigment { color rgb <0.3, 0.4, 0.9> } finish { ambient 0.1 diffuse 0.7 specular 0.5 roughness 0.25 }
  scale <0.5, 0.9, 1.3> rotate <0, 35, 25> translate <2.4, 1, 1.2> }
