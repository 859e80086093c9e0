// What objects answer while the scene is read: balls where rays meet a height field of a set, boxes around objects, a pattern of letters.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0.6, 0> angle 40 }
light_source { <4, 9, -8>, rgb 1 }
#declare Hill = difference {
  union { sphere { <-1.5, -0.4, 0>, 1.6 } torus { 1, 0.5 translate <1.6, 0, 0> } }
  cylinder { <-1.5, -3, 0>, <-1.5, 3, 0>, 0.5 }
  plane { y, 0 }
}
object { Hill pigment { rgb <0.4, 0.6, 0.3> } }
#declare N = <0, 0, 0>;
#for (I, 0, 8)
  #for (K, 0, 4)
    #local P = trace(Hill, <I * 0.75 - 3, 5, K * 0.5 - 1>, -y, N);
    #if (vlength(N) != 0)
      cylinder { P, P + 0.4 * N, 0.06 pigment { rgb <1, 0.5, 0> } }
    #else
      #if (inside(Hill, <I * 0.75 - 3, 0.2, K * 0.5 - 1>)) sphere { P, 9 } #end
      sphere { <I * 0.75 - 3, 0.1, K * 0.5 - 1>, 0.1 pigment { rgb <0.2, 0.4, 1> } }
    #end
  #end
#end
#declare Word = text { ttf "timrom.ttf" "ask" 0.4, 0 scale 1.6 rotate 90*x };
#local A = min_extent(Word);
#local B = max_extent(Word);
plane { y, 0
  texture {
    object { object { Word translate -(A + B) / 2 } texture { pigment { rgb 0.7 } } texture { pigment { rgb <0.8, 0.1, 0.1> } }  }
    translate <0, 0, -2.2>
  }
}
box { min_extent(Hill), <-2.6, 0.3, -2.4>  pigment { object { sphere { 0, 0.5 } scale 0.5 rgb 0.9, rgb <0.1, 0.1, 0.6> } translate <-2.6, 0.3, -1.8> } }
