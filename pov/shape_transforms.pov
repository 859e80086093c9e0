// One declared object in many places: scale with negative and unequal factors, rotations in order, matrices, groups and inverses; texture before and after.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

plane { y, -1 pigment { checker rgb 0.8 rgb <0.25, 0.3, 0.4> } }
background { rgb <0.55, 0.7, 0.9> }

#declare Peg = cone { <0, -0.5, 0>, 0.5, <0, 0.7, 0>, 0.2 pigment { checker rgb <0.9, 0.5, 0.2> rgb <0.3, 0.2, 0.1> scale 0.25 } }
#declare Lean = transform { rotate <20, 0, 30> scale <1, 1.2, 1> }
object { Peg translate <-2.2, -0.3, 0> }
object { Peg transform { Lean } translate <-0.9, -0.2, 0> }
object { Peg transform { Lean inverse } translate <0.5, -0.2, 0> }
object { Peg scale <0.6, -1.1, 1.5> rotate <0, 40, 15> translate <1.9, -0.3, 0> }
object { Peg matrix <0.8, 0.2, 0, 0, 0.8, 0.3, -0.2, 0, 0.8, 0, 1.3, 1.5> }
sphere { <0.6, -0.6, -1.8>, 0.4 scale <1.5, 1, 1> pigment { checker rgb 1 rgb <0.2, 0.3, 0.6> scale 0.2 rotate 30*z } }
