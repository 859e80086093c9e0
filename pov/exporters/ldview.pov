// As LDView writes: versions asked for everywhere, everything declared only where nobody has, seams as macros, textures by colour number, a
// floor at the lowest corner, shapes instead of meshes where it knows them.
#if (version >= 3.7)
#version 3.7;
#else
#version 3.6;
#end
#ifndef (ASPECT) #declare ASPECT = 1.333; #end
#ifndef (QUAL) #declare QUAL = 3; #end
#ifndef (SEAMS) #declare SEAMS = 0.02; #end
#ifndef (SHADOWS) #declare SHADOWS = 1; #end
#ifndef (FLOOR) #declare FLOOR = 1; #end

global_settings {
	assumed_gamma 1.4
	max_trace_level 10
}

#ifndef (Color4)
#declare Color4 = #if (version >= 3.1) material { #end
	texture {
		pigment { #if (version >= 3.7) srgbf #else rgbf #end <0.788,0.1,0.035,0> }
		#if (QUAL > 1) finish { ambient 0.3 diffuse 0.6 phong 0.5 phong_size 40 reflection 0.05 } #end
	}
#if (version >= 3.1) } #end
#end
#ifndef (Color41)
#declare Color41 = material {
	texture {
		pigment { srgbf <0.333,0.603,0.717,0.9> }
		#if (QUAL > 1) finish { ambient 0.1 diffuse 0.3 phong 0.5 reflection 0.1 } #end
	}
	#if (QUAL > 1) interior { ior 1.25 } #end
}
#end
#macro Seam(MIN, MAX)
	#local Size = MAX-MIN;
	#local Gap = vlength(Size)*SEAMS*0.5;
	#local Scale = (Size-<Gap,Gap,Gap>)/Size;
	translate -(MIN+MAX)/2
	scale Scale
	translate (MIN+MAX)/2
#end

#ifndef (stud)
#declare stud = merge {
	cylinder { <0,0,0>, <0,-4,0>, 6 }
	torus { 5.5, 0.5 translate -3.5*y }
	disc { <0,-4,0>, <0,-1,0>, 6 }
}
#end
#ifndef (block)
#declare block = union {
	difference { box { <-20,0,-10>, <20,24,10> } box { <-16,4,-6>, <16,25,6> } }
	object { stud matrix <1,0,0,0,1,0,0,0,1,-10,0,0> }
	object { stud matrix <1,0,0,0,1,0,0,0,1,10,0,0> }
}
#end
#declare model = union {
	object { block Seam(<-20,-4,-10>, <20,24,10>) material { Color4 } }
	object { block material { Color41 } matrix <0,0,-1,0,1,0,1,0,0,10,-24,10> }
	cylinder { <-30,24,-20>, <-30,0,-20>, 4 clipped_by { box { <-30,-10,-30>, <-20,30,-10> } } material { Color4 } }
	mesh {
		triangle { <-40,24,20>, <-20,24,30>, <-30,0,25> }
		triangle { <-40,24,20>, <-30,0,25>, <-38,24,32> }
		material { Color4 }
	}
	#if (SHADOWS = 0) no_shadow #end
}
object { model }
#if (FLOOR)
object { plane { y, 24 } texture { pigment { color srgb <0.8,0.8,0.8> } finish { ambient 0.4 diffuse 0.4 } } }
#end
background { color srgb <0.9,0.9,1> }
light_source { <-80,-200,-150> color rgb <0.7,0.7,0.7> }
light_source { <150,-80,-100> color rgb <0.4,0.4,0.4> }
camera {
	#declare PCT = 1;
	location vaxis_rotate(<0,-60,-160>, y, 20)
	sky -y
	right ASPECT * < -1,0,0 >
	look_at < -4,4,0 >
	angle 34
}
