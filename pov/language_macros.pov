// A tree of macros that call themselves, arrays of textures and places, random numbers, a function, a spline and text made of strings.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -8> look_at <0, 0.9, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }
background { rgb <0.55, 0.7, 0.9> }
plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }

#declare Dice = seed(7);
#declare Coats = array[3] {
    texture { pigment { rgb <0.9, 0.3, 0.2> } },
    texture { pigment { rgb <0.9, 0.8, 0.3> } finish { phong 0.6 } },
    texture { pigment { rgb <0.3, 0.4, 0.9> } }
}

#macro Twist(Value, Least, Most) #declare Value = Least + (Most - Least)*rand(Dice); #end
#macro Branch(Base, Way, Level)
    #local Tip = Base + Way;
    cone { Base, 0.06*Level, Tip, 0.06*(Level - 1) + 0.01 pigment { rgb <0.5, 0.35, 0.2> } }
    #if (Level > 1)
        #for (I, 1, 3)
            #local Turn = 0;
            Twist(Turn, 20, 50)
            Branch(Tip, vrotate(0.75*Way, <0, 0, Turn>*(I - 2) + (I = 2)*<Turn, 0, 0>), Level - 1)
        #end
    #else
        sphere { Tip, 0.12 texture { Coats[mod(floor(3*rand(Dice)), 3)] } }
    #end
#end
Branch(<0, -1, 0>, <0, 1, 0>, 4)

#declare Wave = function (a) { 0.25*sin(radians(a)) + select(a - 180, 0, 0.1) }
#declare Path = spline { natural_spline 0, <-3, 0, 1>  0.4, <-2, 1.5, 2>  1, <3, 0.5, 1> }
#declare Beads = array[13];
#for (I, 0, 12) #declare Beads[I] = Path(I/12) + Wave(30*I)*y; #end
#for (I, 0, dimension_size(Beads, 1) - 1)
    sphere { Beads[I], 0.1 + 0.05*(strcmp(substr("abcabcabcabca", I + 1, 1), "b") = 0) texture { Coats[mod(I, dimension_size(Coats, 1))] } }
#end
