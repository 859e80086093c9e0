// Opaque spheres of one colour each under one lamp, enough for the index.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6>, rgb 1 }
sphere { <-1.05, 0.13, -0.52>, 0.35 pigment { rgb <0.68, 0.5, 0.6> } }
sphere { <0.50, -1.30, -1.95>, 0.35 pigment { rgb <0.87, 0.5, 0.6> } }
sphere { <-0.96, -0.80, 1.98>, 0.35 pigment { rgb <0.58, 0.5, 0.6> } }
sphere { <1.35, -0.07, 0.56>, 0.35 pigment { rgb <0.32, 0.5, 0.6> } }
sphere { <0.54, 1.10, 0.09>, 0.35 pigment { rgb <0.79, 0.5, 0.6> } }
sphere { <0.69, -1.31, 1.03>, 0.35 pigment { rgb <0.67, 0.5, 0.6> } }
sphere { <-0.79, -1.41, 1.46>, 0.35 pigment { rgb <0.58, 0.5, 0.6> } }
sphere { <0.88, 1.14, 0.86>, 0.35 pigment { rgb <0.94, 0.5, 0.6> } }
sphere { <-0.42, 0.90, -0.22>, 0.35 pigment { rgb <0.95, 0.5, 0.6> } }
sphere { <1.52, -1.21, -1.46>, 0.35 pigment { rgb <0.37, 0.5, 0.6> } }
sphere { <1.86, -0.19, 0.51>, 0.35 pigment { rgb <0.44, 0.5, 0.6> } }
sphere { <0.03, -0.34, -0.60>, 0.35 pigment { rgb <0.67, 0.5, 0.6> } }
sphere { <0.34, 1.21, 0.73>, 0.35 pigment { rgb <0.94, 0.5, 0.6> } }
sphere { <1.43, 1.47, 0.69>, 0.35 pigment { rgb <0.33, 0.5, 0.6> } }
sphere { <1.44, 1.39, 1.62>, 0.35 pigment { rgb <0.66, 0.5, 0.6> } }
sphere { <0.86, -0.87, 1.33>, 0.35 pigment { rgb <0.66, 0.5, 0.6> } }
sphere { <-0.86, -1.31, 1.42>, 0.35 pigment { rgb <0.99, 0.5, 0.6> } }
sphere { <-1.65, 0.90, -0.36>, 0.35 pigment { rgb <0.32, 0.5, 0.6> } }
sphere { <-0.82, 0.81, 1.49>, 0.35 pigment { rgb <0.24, 0.5, 0.6> } }
sphere { <0.46, -1.37, 0.87>, 0.35 pigment { rgb <0.46, 0.5, 0.6> } }
sphere { <1.52, 1.44, 0.02>, 0.35 pigment { rgb <1.00, 0.5, 0.6> } }
sphere { <-0.76, -1.27, 0.40>, 0.35 pigment { rgb <0.23, 0.5, 0.6> } }
sphere { <-1.21, -0.28, 0.44>, 0.35 pigment { rgb <0.32, 0.5, 0.6> } }
sphere { <-1.83, 1.10, -0.74>, 0.35 pigment { rgb <0.97, 0.5, 0.6> } }
sphere { <1.59, -0.37, -0.16>, 0.35 pigment { rgb <0.62, 0.5, 0.6> } }
sphere { <0.58, 0.29, 0.24>, 0.35 pigment { rgb <0.70, 0.5, 0.6> } }
sphere { <1.76, 0.02, -0.28>, 0.35 pigment { rgb <0.78, 0.5, 0.6> } }
sphere { <-1.05, -0.60, 1.91>, 0.35 pigment { rgb <0.62, 0.5, 0.6> } }
sphere { <0.19, -1.47, -0.34>, 0.35 pigment { rgb <0.66, 0.5, 0.6> } }
sphere { <-1.92, 0.35, 0.53>, 0.35 pigment { rgb <0.25, 0.5, 0.6> } }
