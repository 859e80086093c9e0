// Objects without textures take the default; a second #default applies to what follows; finishes are copied from declared ones.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.2, -7> look_at <0, 0, 0> right x*4/3 angle 45 }
light_source { <5, 8, -6>, rgb 1 }

background { rgb <0.3, 0.4, 0.6> }
#declare Soft = finish { ambient 0.2 diffuse 0.5 }
sphere { <-2.2, 0.4, 0>, 0.8 }
#default { pigment { rgb <0.7, 0.5, 0.3> } finish { Soft phong 0.6 } }
sphere { <-0.5, 0.4, 0>, 0.8 }
#default { finish { reflection 0.3 } }
sphere { <1.2, 0.4, 0>, 0.8 pigment { rgb <0.3, 0.6, 0.5> } }
sphere { <2.6, -0.5, -0.8>, 0.5 finish { Soft } }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.4 } finish { reflection 0 } }
