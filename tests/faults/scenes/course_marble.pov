// A glass egg and a metal pill that are squeezed and turned, lit by one white and one dim lamp; the course's Cook-Torrance.
camera { location <-2, 2.5, 6> up <0, 1, 0> right <1.3333, 0, 0> look_at <0, 0, 0> }
light_source { <-5, 7, 4> color rgb <1.3, 1.2, 1> }
light_source { <6, 2, 5> color rgb <0.15, 0.2, 0.35> }
plane { <0, 1, 0.1>, -1.5 pigment { color rgb <0.4, 0.55, 0.75> } finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.5 ior 1.5 } }
sphere { <0, 0, 0>, 1
  pigment { color rgbf <1, 0.85, 0.6, 0.7> } finish { ambient 0.1 diffuse 0.4 specular 0.5 roughness 0.3 reflection 0.15 ior 1.5 }
  scale <0.9, 1.3, 0.8> rotate <0, 0, 20> translate <-1.2, 0.2, 0.4> }
sphere { <0, 0, 0>, 1
  pigment { color rgb <0.8, 0.75, 0.7> } finish { ambient 0.1 diffuse 0.5 specular 0.7 roughness 0.4 ior 2.4 }
  scale <1.4, 0.6, 0.7> rotate <0, 30, 10> translate <1.4, -0.5, 0.2> }
