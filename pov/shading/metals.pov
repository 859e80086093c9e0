// Five metals by their complex index of refraction, in rows, each at five widths m of the microfacets' slopes, in columns: a lecture's form of
// Cook and Torrance's model with the exact Fresnel term. Indices at about 650, 550 and 450 nm.
#version 3.7;
//! raytrace: shading=lecture F=conductor s=0.9
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { orthographic location <0, 0, -10> right 11*x up 11*y look_at 0 }
background { rgb <0.045, 0.05, 0.06> }
light_source { <-9, 11, -14>, rgb <1.5, 1.45, 1.35> }
light_source { <16, 3, -7>, rgb <0.6, 0.7, 0.85> }
light_source { <-3, -14, -6>, rgb <0.4, 0.34, 0.3> }
light_source { <-12, 3, 5>, rgb 0.8 }

// Gold
sphere { <-4.3, 4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.1
} no_shadow no_reflection }
sphere { <-2.1, 4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.2
} no_shadow no_reflection }
sphere { <0.0, 4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.3
} no_shadow no_reflection }
sphere { <2.1, 4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.45
} no_shadow no_reflection }
sphere { <4.3, 4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.143,0.375,1.442 k=3.983,2.386,1.603 alpha=0.65
} no_shadow no_reflection }
// Copper
sphere { <-4.3, 2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.200,0.924,1.102 k=3.912,2.452,2.142 alpha=0.1
} no_shadow no_reflection }
sphere { <-2.1, 2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.200,0.924,1.102 k=3.912,2.452,2.142 alpha=0.2
} no_shadow no_reflection }
sphere { <0.0, 2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.200,0.924,1.102 k=3.912,2.452,2.142 alpha=0.3
} no_shadow no_reflection }
sphere { <2.1, 2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.200,0.924,1.102 k=3.912,2.452,2.142 alpha=0.45
} no_shadow no_reflection }
sphere { <4.3, 2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.200,0.924,1.102 k=3.912,2.452,2.142 alpha=0.65
} no_shadow no_reflection }
// Silver
sphere { <-4.3, 0.0, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.155,0.117,0.138 k=4.828,3.122,2.147 alpha=0.1
} no_shadow no_reflection }
sphere { <-2.1, 0.0, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.155,0.117,0.138 k=4.828,3.122,2.147 alpha=0.2
} no_shadow no_reflection }
sphere { <0.0, 0.0, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.155,0.117,0.138 k=4.828,3.122,2.147 alpha=0.3
} no_shadow no_reflection }
sphere { <2.1, 0.0, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.155,0.117,0.138 k=4.828,3.122,2.147 alpha=0.45
} no_shadow no_reflection }
sphere { <4.3, 0.0, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=0.155,0.117,0.138 k=4.828,3.122,2.147 alpha=0.65
} no_shadow no_reflection }
// Aluminium
sphere { <-4.3, -2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=1.657,0.880,0.521 k=9.224,6.270,4.837 alpha=0.1
} no_shadow no_reflection }
sphere { <-2.1, -2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=1.657,0.880,0.521 k=9.224,6.270,4.837 alpha=0.2
} no_shadow no_reflection }
sphere { <0.0, -2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=1.657,0.880,0.521 k=9.224,6.270,4.837 alpha=0.3
} no_shadow no_reflection }
sphere { <2.1, -2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=1.657,0.880,0.521 k=9.224,6.270,4.837 alpha=0.45
} no_shadow no_reflection }
sphere { <4.3, -2.1, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=1.657,0.880,0.521 k=9.224,6.270,4.837 alpha=0.65
} no_shadow no_reflection }
// Iron
sphere { <-4.3, -4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=2.912,2.950,2.585 k=3.089,2.932,2.767 alpha=0.1
} no_shadow no_reflection }
sphere { <-2.1, -4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=2.912,2.950,2.585 k=3.089,2.932,2.767 alpha=0.2
} no_shadow no_reflection }
sphere { <0.0, -4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=2.912,2.950,2.585 k=3.089,2.932,2.767 alpha=0.3
} no_shadow no_reflection }
sphere { <2.1, -4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=2.912,2.950,2.585 k=3.089,2.932,2.767 alpha=0.45
} no_shadow no_reflection }
sphere { <4.3, -4.3, 0>, 0.98 pigment { rgb 0 } finish { ambient 0 diffuse 0
    //! raytrace: eta=2.912,2.950,2.585 k=3.089,2.932,2.767 alpha=0.65
} no_shadow no_reflection }
