// As PyMOL writes: numbers that touch keywords, an orthographic camera that looks along -z, one triangle a mesh2 (of one colour, or of one a corner),
// open cylinders, a back plane.
camera {orthographic location <0.0 , 0.0 , 20.0>
look_at  <0.0 , 0.0 , -1.0> right 8.0*x up 6.0*y }
#default { texture { pigment{color rgb <1.0,1.0,1.0>} finish{ ambient 0.1400 diffuse 0.4500 phong 0.4 phong_size 20.0 } } }
light_source{<4000.0001,4000.0001,9947.0836>  rgb<1.0,1.0,1.0>}
light_source{<0.0,0.0,40.0> rgb<0.4500,0.4500,0.4500>shadowless}
plane{z , -12.5000
 pigment{color rgb<0.1000,0.1000,0.1500>}finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
sphere{<-2.0000000000,-0.5000000000,0.0000000000>, 0.7000000000
pigment{color rgb<0.2000,1.0000,0.2000>}}
sphere{<1.2,0.8,-0.5>, 0.50001pigment{color rgb<1.0000,0.3000,0.3000>transmit 0.4}}
cylinder{<-2.0000000000,-0.5000000000,0.0000000000>,
<1.2000000000,0.8000000000,-0.5000000000>,
 0.2500000000
 open
pigment{color rgb<0.9000,0.7750,0.2500>}}
mesh2 { vertex_vectors { 3, <0.5,-2.0,0.0>,<3.0,-1.5,0.5>,<1.5,0.2,-0.3>}
 normal_vectors { 3, <-0.3,-0.2,1.0>,<0.4,0.0,0.9>,<0.0,0.5,0.8>}
 face_indices { 1, <0,1,2> }
pigment{color rgb<0.2000,0.2000,1.0000>}}
mesh2 { vertex_vectors { 3, <-1.6,-2.4,0.5>,
<0.4,-2.2,-0.5>,
<-0.8,-0.9,0.2>}
 normal_vectors { 3,
<-0.4,-0.3,0.9>,
<0.3,-0.2,0.9>,
<0.1,0.4,0.9>}
texture_list { 3, texture { pigment{color rgb<1.00001,0.1000,0.1000> transmit 0.3}}
,texture { pigment{color rgb<0.10001,1.0000,0.2000> transmit 0.3}}
,texture { pigment{color rgb<0.20001,0.3000,1.0000> transmit 0.3}} }
face_indices { 1, <0,1,2>, 0, 1, 2 } }
