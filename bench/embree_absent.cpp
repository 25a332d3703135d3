// Stands for embree_side.cpp where CMake finds no Embree.
#include "bench/trace_side.h"

namespace lray::bench {

std::vector<std::unique_ptr<TraceSide>> make_embree_sides(const scene::World&, bvh::BuildQuality,
                                                          bool) {
    return {};
}

}  // namespace lray::bench
