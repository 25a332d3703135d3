#include "pair.inc"
Orthographic(<1, 4, 6>, <0.2, 0.3, 0>, y, 5)
PointLight(<-2, 4, 3>, 220)
PointLight(<4, 3, 1>, 120 * <1, 0.5, 0.3>)
#declare Paint = texture { pigment { rgb <0.6, 0.6, 0.5> } finish { ambient 0 diffuse 1 } }
plane { y, 0 texture { Paint } }
sphere { <-0.5, 0.8, 0.2>, 0.6 texture { Paint } }
triangle { <0.6, 0.5, -0.6>, <1.7, 0.4, 0.1>, <1, 1.6, 0> texture { Paint } }
