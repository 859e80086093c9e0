// As VMD writes: clips in arrays of which most elements are never set, tests of them inside objects, colours as arguments, triangles of
// three colours by gradients under two matrices.
#if (version < 3.5)
#error "POV-Ray 3.5 or above, please.\n"
#end
#declare clip_on=array[3] {0, 1, 0};
#declare clip=array[3];
#declare clip[1] = plane { <-0.3, 0.2, -1>, 0.35 }
#macro ball (P1, R1, C1)
  #local T = texture { pigment { C1 } }
  #if(clip_on[2])
  intersection {
    sphere {P1, R1 texture {T} #if(clip_on[1]) clipped_by {clip[1]} #end no_shadow}
    clip[2]
  }
  #else
  sphere {P1, R1 texture {T} #if(clip_on[1]) clipped_by {clip[1]} #end no_shadow}
  #end
#end
#macro tube (P1, P2, R1, C1, O1)
  #local T = texture { pigment { C1 } }
  cylinder {P1, P2, R1 #if(O1) open #end texture {T} #if(clip_on[1]) clipped_by {clip[1]} #end no_shadow}
#end
#macro tricolor (P1, P2, P3, N1, N2, N3, C1, C2, C3)
  #local NX = P2-P1;
  #local NY = P3-P1;
  #local NZ = vcross(NX, NY);
  #local T = texture { pigment {
    average pigment_map {
      [1 gradient x color_map {[0 rgb 0] [1 C2*3]}]
      [1 gradient y color_map {[0 rgb 0] [1 C3*3]}]
      [1 gradient z color_map {[0 rgb 0] [1 C1*3]}]
    }
    matrix <1.01,0,1,0,1.01,1,0,0,1,-.002,-.002,-1>
    matrix <NX.x,NX.y,NX.z,NY.x,NY.y,NY.z,NZ.x,NZ.y,NZ.z,P1.x,P1.y,P1.z>
  } }
  smooth_triangle {P1, N1, P2, N2, P3, N3 texture {T} no_shadow}
#end
camera {
  orthographic
  location <0.0000, 0.0000, -2.0000>
  look_at <-0.0000, -0.0000, 2.0000>
  up <0.0000, 3.0000, 0.0000>
  right <4.0000, 0.0000, 0.0000>
}
light_source { 
  <-0.1000, 0.1000, -1.0000> 
  color rgb<1.000, 1.000, 1.000> 
  parallel 
  point_at <0.0, 0.0, 0.0> 
}
light_source { 
  <1.0000, 2.0000, -0.5000> 
  color rgb<0.500, 0.500, 0.500> 
  parallel 
  point_at <0.0, 0.0, 0.0> 
}
background {
  color rgb<1.000, 1.000, 1.000>
}
#default { texture {
 finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.000 specular 0.500 }
} }
ball(<-0.8031,0.2013,0.1052>,0.5500,rgbt<0.250,0.750,0.750,0.000>)
ball(<0.3031,-0.4013,0.3052>,0.3500,rgbt<1.000,0.000,0.000,0.300>)
tube(<-0.80312,0.20134,0.10523>,<0.30312,-0.40134,0.30523>,0.0900,rgbt<0.350,0.350,0.350,0.000>,1)
tricolor(<0.4,0.1,0.2>,<1.7,0.3,0.5>,<0.9,1.2,-0.1>,<-0.2,-0.1,-1>,<0.3,-0.2,-1>,<0,0.4,-1>,rgb<1,0.1,0.1>,rgb<0.1,1,0.1>,rgb<0.1,0.1,1>)
// End of POV-Ray 3.x generation 
