// The walk through a tree of boxes in plain C++: what the vector code of bvh/simd/ must do, and
// what runs where there is none.
#pragma once

#include "bvh/simd/walk.h"

namespace lray::bvh {

Walks scalar_walks();

}  // namespace lray::bvh
