// Two mirrors face to face with a ball and a lens between them: rays end by their depth; by the course's rules.
camera { location <0.5, 0.7, 3.6> up <0, 1, 0> right <1.3333, 0, 0> look_at <0, 0, -1> }
light_source { <2.5, 3, 3> color rgb <0.8, 0.8, 1> }
light_source { <-2, 2.5, -2> color rgb <0.5, 0.3, 0.2> }
plane { <0, 0, 1>, -3 pigment { color rgb <0.9, 0.9, 0.8> } finish { ambient 0.1 diffuse 0.2 reflection 0.7 } }
plane { <0, 0, -1>, -5 pigment { color rgb <0.8, 0.9, 0.9> } finish { ambient 0.1 diffuse 0.2 reflection 0.7 } }
plane { <0, 1, 0>, -1 pigment { color rgb <0.5, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.7 } }
sphere { <-0.9, -0.2, -0.6>, 0.8 pigment { color rgb <0.9, 0.6, 0.2> } finish { ambient 0.1 diffuse 0.5 specular 0.7 roughness 0.1 reflection 0.4 } }
sphere { <0, 0, 0>, 1
  pigment { color rgbf <0.95, 0.9, 1, 0.9> } finish { ambient 0 diffuse 0.2 specular 0.5 roughness 0.1 ior 1.33 }
  scale <0.8, 0.8, 0.3> translate <1, 0, 0.6> }
