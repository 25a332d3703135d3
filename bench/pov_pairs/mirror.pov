#include "pair.inc"
background { rgb <0.1, 0.2, 0.4> }
Orthographic(<1, 3, 6>, <0, 0.6, 0>, y, 4)
PointLight(<2, 5, 4>, 260)
#declare Mirror = texture {
  pigment { rgb 0.1 }
  finish { ambient 0 diffuse 1 reflection { rgb <0.7, 0.6, 0.5> } }
}
plane {
  y, 0
  pigment { rgb <0.3, 0.35, 0.3> }
  finish { ambient 0 diffuse 1 reflection { 0.3 } }
}
sphere { <-0.8, 0.8, 0>, 0.8 texture { Mirror } }
sphere { <0.9, 0.7, 0.4>, 0.6 pigment { rgb <0.6, 0.1, 0.1> } BlinnPhong(0.1, 30) }
polygon {
  5, <-2, 0, -1.4>, <2, 0, -1.4>, <2, 1.9, -1.7>, <-2, 1.9, -1.7>, <-2, 0, -1.4>
  texture { Mirror }
}
