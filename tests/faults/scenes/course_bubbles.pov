// Glass in glass and a coloured one before it over a mirror floor; by the course's rules with Fresnel.
camera { location <-1, 2.2, 7> up <0, 1, 0> right <1.3333, 0, 0> look_at <0.2, 0.4, 0> }
light_source { <5, 9, 5> color rgb <0.9, 0.9, 0.8> }
light_source { <-6, 6, 2> color rgb <0.3, 0.2, 0.4> }
plane { <0, 1, 0>, -1.2 pigment { color rgb <0.6, 0.65, 0.5> } finish { ambient 0.2 diffuse 0.5 reflection 0.35 } }
plane { <0.2, 0, 1>, -6 pigment { color rgb <0.5, 0.3, 0.7> } finish { ambient 0.35 diffuse 0.6 } }
sphere { <0, 0.3, 0>, 1.5
  pigment { color rgbf <0.9, 0.95, 1, 0.85> } finish { ambient 0.05 diffuse 0.2 specular 0.6 roughness 0.12 ior 1.45 } }
sphere { <0.1, 0.2, 0.1>, 0.7
  pigment { color rgbf <1, 0.7, 0.4, 0.7> } finish { ambient 0.1 diffuse 0.4 specular 0.3 roughness 0.2 ior 1.8 } }
sphere { <2, -0.3, 2.2>, 0.8
  pigment { color rgbf <0.4, 0.9, 0.5, 0.6> } finish { ambient 0.1 diffuse 0.5 specular 0.5 roughness 0.18 reflection 0.2 ior 1.3 } }
