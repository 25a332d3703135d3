#include "pair.inc"
background { rgb <0.02, 0.03, 0.05> }
Orthographic(<2, 3, 6>, <0, 0, 0>, y, 4)
PointLight(<3, 6, 5>, 480)
#declare Paint = texture { pigment { rgb <0.5, 0.35, 0.2> } BlinnPhong(0.2, 20) }
cylinder { <-1.3, -1, 0.2>, <-0.7, 1, -0.3>, 0.5 texture { Paint } }
cone { <1, -1, 0>, 0.7, <1.2, 1.1, 0.4>, 0.25 texture { Paint } }
