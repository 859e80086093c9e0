// As Jmol writes: lengths in pixels, a camera that is turned by a negative right and a downward sky, a number after metallic, macros of one
// letter, boxes that clip quadrics.
#declare Width = 400;
#declare Height = 300;
#declare noShadows = true;
camera{
  orthographic
  location < Width/2, Height/2, 0>
  // Negative right for a right hand coordinate system.
  sky < 0, -1, 0 >
  right < -Width, 0, 0>
  up < 0, Height, 0 >
  look_at < 200.0, 150.0, 1000.0 >
}
background { color rgb <0.0,0.0,0.05> }
light_source { <-300.0,-400.0,-1000.0>  rgb <0.9,0.9,0.9> }

#macro shadowsOff()
 #if (noShadows)
  no_shadow 
 #end
#end
#macro lit(T)
 #local shine = T;
 #if (T <= 0.25)
  #declare shine = (1.0-4*T);
 #end
 #if (T > 0.25)
  #declare shine = 0;
 #end
 finish {
  ambient 0.45
  diffuse 0.84
  specular 0.22
  roughness .001
  metallic shine
  phong 0.9*shine
  phong_size 120*shine
 }
#end
#macro a(X,Y,Z,RADIUS,R,G,B,T)
 sphere{<X,Y,Z>,RADIUS
  pigment{rgbt<R,G,B,T>}
  lit(T)
  shadowsOff()}
#end
#macro q(XX,YY,ZZ,X,Y,Z,J,R,G,B,T)
 quadric{<XX,YY,ZZ>,<0,0,0>,<X,Y,Z>,J
  clipped_by { box {<0,0,600>,<Width,Height,800>} }
  pigment{rgbt<R,G,B,T>}
  lit(T)
  shadowsOff()}
#end
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2 open
  pigment{rgbt<R,G,B,T>}
  lit(T)
  shadowsOff()}
#end
#macro r(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3,R,G,B,T)
 triangle{<X1,Y1,Z1>,<X2,Y2,Z2>,<X3,Y3,Z3>
  pigment{rgbt<R,G,B,T>}
  lit(T)
  shadowsOff()}
#end
a(120,120,700,50,0.56,0.56,0.56,0.0)
a(250,170,720,40,1.0,0.05,0.05,0.4)
b(120,120,700,12,250,170,720,6,0.9,0.9,0.3,0.0)
q(1.0E-4,4.0E-4,2.0E-4,-0.066,-0.048,-0.28,106.33,0.2,0.6,0.9,0.2)
r(40,250,650,180,280,760,140,180,740,0.2,0.9,0.3,0.1)
polygon { 5, <300,40,700>,<380,40,720>,<380,110,720>,<300,110,700>,<300,40,700> pigment{rgbt<0.9,0.6,0.2,0.2>} lit(0.2) shadowsOff() }
