// Loops in each other, a switch with falling through, ranges and breaks, a macro that is called in a loop.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 4.5, -8> look_at <0, -0.3, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }
background { rgb <0.55, 0.7, 0.9> }
plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }

#macro Piece(Kind, Place)
    #switch (Kind)
        #case (0)
            sphere { Place, 0.3 pigment { rgb <0.9, 0.3, 0.2> } }
        #break
        #case (1)
            box { Place - 0.25, Place + 0.25 pigment { rgb <0.3, 0.7, 0.3> } }
        #case (2)
            cylinder { Place, Place + 0.6*y, 0.12 pigment { rgb <0.9, 0.8, 0.3> } }
        #break
        #range (3, 4)
            torus { 0.25, 0.1 translate Place pigment { rgb <0.3, 0.4, 0.9> } }
        #break
        #else
            cone { Place - 0.3*y, 0.3, Place + 0.5*y, 0 pigment { rgb <0.7, 0.4, 0.8> } }
    #end
#end

#for (Row, -2, 2)
    #local Column = -3;
    #while (1)
        Piece(mod(5*(Row + 2) + Column + 3, 6), <Column, -0.7, Row>)
        #local Column = Column + 1;
        #if (Column > 3 - abs(Row)) #break #end
    #end
#end
