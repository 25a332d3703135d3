#include "pair.inc"
Orthographic(<3, 5, 8>, <0, 0, 0>, y, 6)
PointLight(<0.5, 1.5, 0.3>, 16 * <1, 0.9, 0.7>)
PointLight(<-2, 2, -1>, 20 * <0.2, 0.4, 1>)
#declare Normal = vnormalize(<0.1, 1, 0.05>);
plane {
  Normal, vdot(Normal, <0, 0.1, 0>)
  pigment { rgb <0.7, 0.6, 0.5> }
  BlinnPhong(0.3, 25)
}
