#include "pair.inc"
Orthographic(<1, 3, 6>, <0, 0.5, 0>, y, 4)
PointLight(<2, 5, 4>, 300)
#declare Matt = finish { ambient 0 diffuse 1 }
#declare Tiles = texture {
  pigment { checker rgb <0.6, 0.5, 0.2> rgb <0.1, 0.2, 0.4> scale 0.45 }
  finish { Matt }
}
#declare Rings = texture {
  pigment {
    gradient y
    color_map {
      [0 rgb <0.6, 0.1, 0.1>]
      [0.4 rgb <0.1, 0.6, 0.3>]
      [1 rgb <0.6, 0.1, 0.1>]
    }
    scale 0.7
  }
  finish { Matt }
}
plane { y, -0.1 texture { Tiles } }
sphere { <-0.9, 0.9, 0>, 0.8 texture { Rings } }
sphere { <1, 0.8, 0.3>, 0.7 texture { Tiles } }
