// As FreeCAD writes: the camera from declared vectors, a declared finish, each face of a part a declared mesh2 without texture, the part a union of
// them by their names, numbers with exponents, a bright lamp by the camera.
#version 3.6;
global_settings { assumed_gamma 1.0 }
#default { finish { ambient 0.2 diffuse 0.9 } }
background { rgb <0.85, 0.88, 0.95> }
#declare StdFinish = finish { ambient 0.01 diffuse 0.9 phong 1.0 phong_size 70 metallic brilliance 1.5} ;

#declare cam_location =  <-21.7,23.1,-36.6>;
#declare cam_look_at  = <4,3.5,3>;
#declare cam_sky      = <0.068217,0.958943,0.275273>;
#declare cam_angle    = 25;
camera {
  location  cam_location
  look_at   cam_look_at
  sky       cam_sky
  angle     cam_angle
  right x*800/600
}
// face number1 +++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++
#declare Wedge1 = mesh2{
  vertex_vectors {
    4,
    <0,6,0>,
    <8,6,1.2e-15>,
    <8,9,7>,
    <-1.1e-16,9,7>,
  }
  normal_vectors {
    4,
    <0,0.919145,-0.393919>,
    <0,0.919145,-0.393919>,
    <0.1,0.919145,-0.393919>,
    <-0.1,0.919145,-0.393919>,
  }
  face_indices {
    2,
    <0,2,1>,
    <0,3,2>,
  }
} // end of Face1

// face number2 +++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++
#declare Wedge2 = mesh2{
  vertex_vectors {
    4,
    <0,0,0>,
    <8,0,0>,
    <8,6,0>,
    <0,6,0>,
  }
  normal_vectors {
    4,
    <0,0,-1>,
    <0,0,-1>,
    <0,0,-1>,
    <0,0,-1>,
  }
  face_indices {
    2,
    <0,2,1>,
    <0,3,2>,
  }
} // end of Face2

// face number3 +++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++
#declare Wedge3 = mesh2{
  vertex_vectors {
    4,
    <0,0,0>,
    <0,6,0>,
    <0,9,7>,
    <0,0,7>,
  }
  normal_vectors {
    4,
    <-1,0,0>,
    <-1,0,0>,
    <-1,0,0>,
    <-1,0,0>,
  }
  face_indices {
    2,
    <0,2,1>,
    <0,3,2>,
  }
} // end of Face3



// Declare all together +++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++++
#declare Wedge = union {
mesh2{ Wedge1}
mesh2{ Wedge2}
mesh2{ Wedge3}
}
object { Wedge
 texture {
      pigment {
        color rgb <0.80,0.45,0.20>
      }
      finish {StdFinish }
  }
}
object { Wedge
  translate <10,0,3>
 texture {
      pigment {
        color rgb <0.30,0.50,0.80> transmit 0.35
      }
      finish {StdFinish }
  }
}
plane { y, -0.05 pigment { checker rgb 0.7, rgb 0.5 scale 4 } finish { ambient 0.3 } }
light_source {
  cam_location + cam_angle * 1
  color rgb <1.2, 1.2, 1.2>
}
