// Single triangles that lamps light from both sides, and a lamp with nothing but a sphere behind it; by the course's rules.
camera { location <2, 1.4, 5> up <0, 1, 0> right <1.3333, 0, 0> look_at <0, 0.3, 0> }
light_source { <1.5, 2.5, 2> color rgb <0.9, 0.5, 0.5> }
light_source { <-2, 1.5, -2> color rgb <0.4, 0.8, 0.6> }
triangle { <-2, -0.8, 0>, <1.2, -0.6, 0.6>, <-0.6, 1.8, -0.3>
  pigment { color rgb <0.5, 0.8, 0.3> } finish { ambient 0.2 diffuse 0.7 specular 0.3 roughness 0.4 } }
triangle { <0.4, -0.9, -1>, <2.6, -0.5, -0.4>, <1.6, 1.6, -1.2>
  pigment { color rgb <0.8, 0.7, 0.3> } finish { ambient 0.15 diffuse 0.6 specular 0.5 roughness 0.3 reflection 0.2 } }
sphere { <1.8, 3.6, 2.6>, 0.5 pigment { color rgb <0.8, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.7 } }
plane { <0, 1, 0>, -1 pigment { color rgb <0.6, 0.6, 0.7> } finish { ambient 0.2 diffuse 0.6 } }
