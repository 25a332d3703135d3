#include "pair.inc"
background { rgb <0.02, 0.03, 0.05> }
Orthographic(<0.013, 0.007, 5>, <0.013, 0.007, 0>, y, 3)
PointLight(<3, 4, 5>, 380)
sphere { <0.1, -0.1, 0>, 1.2 pigment { rgb <0.6, 0.3, 0.15> } BlinnPhong(0.25, 40) }
