// A prism of triangles and a glass brick that is turned, before a wall; by the course's rules with Fresnel and Beer.
camera { location <0.4, 1.6, 6.5> up <0, 1, 0> right <1.3333, 0, 0> look_at <0, 0.5, 0> }
light_source { <-3, 8, 6> color rgb <1, 0.95, 0.85> }
plane { <0, 0, 1>, -4 pigment { color rgb <0.8, 0.55, 0.3> } finish { ambient 0.3 diffuse 0.6 } }
plane { <0, 1, 0>, -1 pigment { color rgb <0.3, 0.5, 0.6> } finish { ambient 0.25 diffuse 0.6 specular 0.3 roughness 0.4 } }
box { <-0.8, -0.6, -0.5>, <0.8, 0.7, 0.5>
  pigment { color rgbf <0.7, 0.9, 0.8, 0.8> } finish { ambient 0.05 diffuse 0.3 specular 0.4 roughness 0.15 ior 1.6 }
  rotate <10, 38, 0> translate <-1.3, 0.2, 0.3> }
triangle { <0.6, -1, 0.8>, <2.6, -1, 0.6>, <1.6, 1.4, 0.1>
  pigment { color rgb <0.7, 0.3, 0.35> } finish { ambient 0.15 diffuse 0.7 specular 0.5 roughness 0.3 } }
triangle { <2.6, -1, 0.6>, <1.9, -1, -1.4>, <1.6, 1.4, 0.1>
  pigment { color rgb <0.4, 0.3, 0.75> } finish { ambient 0.15 diffuse 0.7 specular 0.5 roughness 0.3 reflection 0.25 } }
triangle { <1.9, -1, -1.4>, <0.6, -1, 0.8>, <1.6, 1.4, 0.1>
  pigment { color rgb <0.3, 0.7, 0.35> } finish { ambient 0.15 diffuse 0.7 } }
