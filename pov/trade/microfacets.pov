// Spheres by roughness (across) and surface (down: plastic, metal, glazed), three lamps: highlights of every width. Written by generate.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 6*y }
background { rgb 0.08 }
light_source { <6, 7, -8>, rgb 1.2 }
light_source { <-7, 2, -6>, rgb <0.4, 0.5, 0.7> }
light_source { <1, -6, 1>, rgb <0.8, 0.6, 0.4> }

sphere { <-3.00, 1.80, 0>, 0.68 pigment { rgb <0.6, 0.15, 0.1> } finish { ambient 0.05 diffuse 0.7 specular 0.5 roughness 0.1 } }
sphere { <-1.50, 1.80, 0>, 0.68 pigment { rgb <0.6, 0.15, 0.1> } finish { ambient 0.05 diffuse 0.7 specular 0.5 roughness 0.2 } }
sphere { <0.00, 1.80, 0>, 0.68 pigment { rgb <0.6, 0.15, 0.1> } finish { ambient 0.05 diffuse 0.7 specular 0.5 roughness 0.35 } }
sphere { <1.50, 1.80, 0>, 0.68 pigment { rgb <0.6, 0.15, 0.1> } finish { ambient 0.05 diffuse 0.7 specular 0.5 roughness 0.5 } }
sphere { <3.00, 1.80, 0>, 0.68 pigment { rgb <0.6, 0.15, 0.1> } finish { ambient 0.05 diffuse 0.7 specular 0.5 roughness 0.7 } }
sphere { <-3.00, 0.00, 0>, 0.68 pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0.02 diffuse 0.15 specular 0.95 metallic roughness 0.1 } }
sphere { <-1.50, 0.00, 0>, 0.68 pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0.02 diffuse 0.15 specular 0.95 metallic roughness 0.2 } }
sphere { <0.00, 0.00, 0>, 0.68 pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0.02 diffuse 0.15 specular 0.95 metallic roughness 0.35 } }
sphere { <1.50, 0.00, 0>, 0.68 pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0.02 diffuse 0.15 specular 0.95 metallic roughness 0.5 } }
sphere { <3.00, 0.00, 0>, 0.68 pigment { rgb <0.9, 0.7, 0.3> } finish { ambient 0.02 diffuse 0.15 specular 0.95 metallic roughness 0.7 } }
sphere { <-3.00, -1.80, 0>, 0.68 pigment { rgb <0.1, 0.25, 0.5> } finish { ambient 0.05 diffuse 0.6 specular 0.3 reflection { 0.05, 0.6 falloff 4 } roughness 0.1 } }
sphere { <-1.50, -1.80, 0>, 0.68 pigment { rgb <0.1, 0.25, 0.5> } finish { ambient 0.05 diffuse 0.6 specular 0.3 reflection { 0.05, 0.6 falloff 4 } roughness 0.2 } }
sphere { <0.00, -1.80, 0>, 0.68 pigment { rgb <0.1, 0.25, 0.5> } finish { ambient 0.05 diffuse 0.6 specular 0.3 reflection { 0.05, 0.6 falloff 4 } roughness 0.35 } }
sphere { <1.50, -1.80, 0>, 0.68 pigment { rgb <0.1, 0.25, 0.5> } finish { ambient 0.05 diffuse 0.6 specular 0.3 reflection { 0.05, 0.6 falloff 4 } roughness 0.5 } }
sphere { <3.00, -1.80, 0>, 0.68 pigment { rgb <0.1, 0.25, 0.5> } finish { ambient 0.05 diffuse 0.6 specular 0.3 reflection { 0.05, 0.6 falloff 4 } roughness 0.7 } }
