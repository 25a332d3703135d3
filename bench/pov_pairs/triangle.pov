#include "pair.inc"
background { rgb <0.02, 0.03, 0.05> }
Orthographic(<0.013, 0.007, 5>, <0.013, 0.007, 0>, y, 3)
PointLight(<1, 2, 4>, 150)
#declare Paint = texture { pigment { rgb <0.2, 0.5, 0.6> } BlinnPhong(0.2, 60) }
triangle { <-1.9, -1, 0.3>, <-0.1, -1.2, -0.4>, <-1.1, 1.1, 0.1> texture { Paint } }
smooth_triangle {
  <0.1, -1.1, 0>, vnormalize(<-0.4, -0.3, 1>),
  <1.8, -0.9, 0>, vnormalize(<0.5, -0.2, 1>),
  <0.9, 1.2, 0>, vnormalize(<0, 0.6, 1>)
  texture { Paint }
}
