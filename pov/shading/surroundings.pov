// The surroundings of the teapot: a hall with tall windows at dusk, seen from its middle. Face = 0 to 5 is the face of the cube towards
// +x -x +y -y +z -z; six square pictures make the cube map that --environment takes.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 1 max_trace_level 4 }
#ifndef (Face) #declare Face = 4; #end

#declare Ahead = z; #declare Aside = x; #declare Above = y;
#if (Face = 0) #declare Ahead = x; #declare Aside = -z; #end
#if (Face = 1) #declare Ahead = -x; #declare Aside = z; #end
#if (Face = 2) #declare Ahead = y; #declare Above = -z; #end
#if (Face = 3) #declare Ahead = -y; #declare Above = z; #end
#if (Face = 5) #declare Ahead = -z; #declare Aside = -x; #end
camera { perspective location <0, 1, 0> direction Ahead right 2*Aside up 2*Above }

// Daylight from the windows on the left, lamps on the right, a dim one overhead.
light_source { <-6, 3, -2>, rgb <0.34, 0.42, 0.56> fade_distance 6 fade_power 2 }
light_source { <-6, 3, 3>, rgb <0.34, 0.42, 0.56> fade_distance 6 fade_power 2 }
light_source { <5.6, 3.2, 1.5>, rgb <0.9, 0.55, 0.25> fade_distance 3 fade_power 2 }
light_source { <2.5, 3, 7.4>, rgb <0.9, 0.5, 0.22> fade_distance 2 fade_power 2 }
light_source { <0, 5.4, 0>, rgb 0.22 }

#declare Plaster = finish { ambient 0.06 diffuse 0.65 }
#declare Glow = finish { ambient 0 diffuse 0 emission 1 }
#declare Wood = finish { ambient 0.08 diffuse 0.6 specular 0.4 roughness 0.3 reflection 0.06 }

// The hall: 14 wide, 6.5 high, 18 long.
plane { y, -0.6 texture { checker texture { pigment { rgb <0.32, 0.2, 0.12> } finish { Wood } } texture { pigment { rgb <0.2, 0.12, 0.075> } finish { Wood } } scale 1.2 translate 0.3*x } }
plane { -y, -5.9 pigment { rgb <0.5, 0.47, 0.42> } finish { Plaster } }
plane { x, -7 pigment { rgb <0.3, 0.34, 0.42> } finish { Plaster } }
plane { -x, -7 pigment { rgb <0.55, 0.4, 0.3> } finish { Plaster } }
plane { -z, -9 pigment { rgb <0.22, 0.27, 0.36> } finish { Plaster } }
plane { z, -9 pigment { rgb <0.42, 0.4, 0.42> } finish { Plaster } }

// Four windows on the left and two behind the viewer, three rows of panes each, and the bar in their middle.
#declare High = box { <-0.1, 3.3, -1>, <0.1, 4.6, 1> pigment { rgb <0.62, 0.76, 1> } finish { Glow } }
#declare Middle = box { <-0.1, 1.9, -1>, <0.1, 3.2, 1> pigment { rgb <0.85, 0.9, 1> } finish { Glow } }
#declare Low = box { <-0.1, 0.5, -1>, <0.1, 1.8, 1> pigment { rgb <1, 0.86, 0.68> } finish { Glow } }
#declare Bar = box { <-0.15, 0.3, -0.06>, <0.15, 4.8, 0.06> pigment { rgb <0.16, 0.12, 0.1> } finish { Plaster } }
object { High scale <1, 1, 1.4> translate <-7, 0, -6> }
object { Middle scale <1, 1, 1.4> translate <-7, 0, -6> }
object { Low scale <1, 1, 1.4> translate <-7, 0, -6> }
object { Bar translate <-7, 0, -6> }
object { High scale <1, 1, 1.4> translate <-7, 0, -2> }
object { Middle scale <1, 1, 1.4> translate <-7, 0, -2> }
object { Low scale <1, 1, 1.4> translate <-7, 0, -2> }
object { Bar translate <-7, 0, -2> }
object { High scale <1, 1, 1.4> translate <-7, 0, 2> }
object { Middle scale <1, 1, 1.4> translate <-7, 0, 2> }
object { Low scale <1, 1, 1.4> translate <-7, 0, 2> }
object { Bar translate <-7, 0, 2> }
object { High scale <1, 1, 1.4> translate <-7, 0, 6> }
object { Middle scale <1, 1, 1.4> translate <-7, 0, 6> }
object { Low scale <1, 1, 1.4> translate <-7, 0, 6> }
object { Bar translate <-7, 0, 6> }
object { High rotate 90*y scale <1.7, 1, 1> translate <-3.5, 0, -9> }
object { Middle rotate 90*y scale <1.7, 1, 1> translate <-3.5, 0, -9> }
object { Low rotate 90*y scale <1.7, 1, 1> translate <-3.5, 0, -9> }
object { Bar rotate 90*y scale <1.7, 1, 1> translate <-3.5, 0, -9> }
object { High rotate 90*y scale <1.7, 1, 1> translate <3.5, 0, -9> }
object { Middle rotate 90*y scale <1.7, 1, 1> translate <3.5, 0, -9> }
object { Low rotate 90*y scale <1.7, 1, 1> translate <3.5, 0, -9> }
object { Bar rotate 90*y scale <1.7, 1, 1> translate <3.5, 0, -9> }

// Lamps: two strips under the ceiling, three globes on the right, a lit doorway between pillars ahead.
#declare Strip = box { <-0.25, 5.7, -7>, <0.25, 5.85, 7> pigment { rgb <1, 0.96, 0.88> } finish { Glow } }
object { Strip translate -2.6*x }
object { Strip translate 2.6*x }
#declare Globe = sphere { <6.6, 3.1, 0>, 0.42 pigment { rgb <1, 0.8, 0.5> } finish { Glow } }
#declare Holder = cylinder { <6.6, -0.6, 0>, <6.6, 2.7, 0>, 0.12 pigment { rgb <0.12, 0.1, 0.09> } finish { Wood } }
object { Globe translate -4.5*z }
object { Holder translate -4.5*z }
object { Globe translate 0*z }
object { Holder translate 0*z }
object { Globe translate 4.5*z }
object { Holder translate 4.5*z }
box { <1.3, -0.6, 8.95>, <3.7, 3.4, 9> pigment { rgb <1, 0.68, 0.36> } finish { Glow } }
#declare Pillar = cylinder { -0.6*y, 6*y, 0.45 pigment { rgb <0.6, 0.55, 0.5> } finish { Plaster } }
#declare Base = box { <-0.65, -0.6, -0.65>, <0.65, -0.1, 0.65> pigment { rgb <0.5, 0.45, 0.42> } finish { Plaster } }
object { Pillar translate <-4.6, 0, 7.2> }
object { Base translate <-4.6, 0, 7.2> }
object { Pillar translate <0.2, 0, 7.8> }
object { Base translate <0.2, 0, 7.8> }
object { Pillar translate <4.9, 0, 7.2> }
object { Base translate <4.9, 0, 7.2> }
object { Pillar translate <5.6, 0, -6> }
object { Base translate <5.6, 0, -6> }
object { Pillar translate <-5.2, 0, -7.5> }
object { Base translate <-5.2, 0, -7.5> }
