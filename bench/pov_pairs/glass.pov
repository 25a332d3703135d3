// The glass casts no shadow: what passes through it to a surface is another matter.
#include "pair.inc"
background { rgb <0.5, 0.6, 0.7> }
Orthographic(<1, 2, 6>, <0, 0.7, 0>, y, 4)
PointLight(<2, 5, 4>, 220)
#declare Glass = material {
  texture {
    pigment { rgbt <1, 1, 1, 1> }
    finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
  }
  interior { ior 1.5 }
}
#declare Matt = finish { ambient 0 diffuse 1 }
plane { y, 0 pigment { rgb <0.5, 0.45, 0.4> } finish { Matt } }
sphere { <-0.9, 0.9, 0>, 0.8 material { Glass } no_shadow }
box { <0.4, 0.2, -0.5>, <1.3, 1.4, 0.4> material { Glass } no_shadow }
sphere { <-1.3, 0.5, -1.8>, 0.5 pigment { rgb <0.7, 0.1, 0.1> } finish { Matt } }
sphere { <0.7, 0.6, -2>, 0.6 pigment { rgb <0.1, 0.2, 0.7> } finish { Matt } }
