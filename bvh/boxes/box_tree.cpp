#include "bvh/boxes/box_tree.h"

#include <utility>

#include "base/assert.h"
#include "bvh/boxes/build_refs.h"
#include "bvh/boxes/fill_tree.h"
#include "bvh/boxes/grow_tree.h"
#include "bvh/boxes/ref_set.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

BoxTree build_box_tree(const scene::Geometry& geometry, BuildQuality quality) {
    BuildRefs build = make_build_refs(geometry);
    BoxTree tree;
    if (!build.refs.empty()) {
        LRAY_ASSERT(build.refs.size() <= kMaxLeafFirst * std::size_t{kBoxWidth});
        const GrownPart part = grow_tree(build.refs, quality);
        tree = fill_tree(geometry, build.refs, part);
        const double area = half_area(summarize(build.refs).box);
        tree.stats.nodes = part.counts.nodes;
        tree.stats.leaves = part.leaf_count;
        tree.stats.references = part.ref_count;
        tree.stats.depth = part.depth;
        tree.stats.cost = area > 0.0 ? part.cost / area : 0.0;
    }
    tree.stats.references += build.planes.size();
    tree.planes = std::move(build.planes);
    tree.planes.shrink_to_fit();
    tree.stats.bytes = tree.arena.size() + tree.planes.capacity() * sizeof(scene::PrimitiveId);
    return tree;
}

}  // namespace lray::bvh
