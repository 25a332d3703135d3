#include "bvh/boxes/ref_set.h"

#include <utility>

#include "base/assert.h"
#include "bvh/boxes/box_layout.h"

namespace lray::bvh {

namespace {

/// Divides in place and sums up both sides on the way. Returns how many are left.
template <class IsLeft>
std::uint32_t partition(std::span<BuildRef> refs, RefSummary& left, RefSummary& right,
                        IsLeft is_left) {
    std::size_t begin = 0;
    std::size_t end = refs.size();
    while (true) {
        while (begin < end && is_left(refs[begin])) left.add(refs[begin++]);
        while (begin < end && !is_left(refs[end - 1])) right.add(refs[--end]);
        if (begin >= end) return static_cast<std::uint32_t>(begin);
        std::swap(refs[begin], refs[end - 1]);
    }
}

TwoSets divide_in_middle(std::span<BuildRef> refs, const RefSet& set) {
    // Blocks on the left are full.
    const std::uint32_t half = (set.count() / 2 + kBoxWidth - 1) / kBoxWidth * kBoxWidth;
    const std::uint32_t left_count = half < set.count() ? half : set.count() / 2;
    const std::uint32_t middle = set.first + left_count;
    return {{set.first, middle, summarize(refs.subspan(set.first, left_count))},
            {middle, set.last, summarize(refs.subspan(middle, set.last - middle))}};
}

}  // namespace

RefSummary summarize(std::span<const BuildRef> refs) {
    RefSummary summary;
    for (const BuildRef& ref : refs) summary.add(ref);
    return summary;
}

TwoSets divide(std::span<BuildRef> refs, const RefSet& set, const Split& split) {
    LRAY_ASSERT(split.kind != SplitKind::none && set.count() >= 2);
    if (split.kind == SplitKind::middle) return divide_in_middle(refs, set);
    TwoSets sides;
    const std::span<BuildRef> members = refs.subspan(set.first, set.count());
    std::uint32_t left_count = 0;
    if (split.kind == SplitKind::by_class) {
        const auto first_class = static_cast<unsigned>(std::countr_zero(set.summary.classes));
        left_count = partition(members, sides.left.summary, sides.right.summary,
                               [&](const BuildRef& ref) { return ref.ref_class() == first_class; });
    } else {
        const Float4 plane = Float4::fill(static_cast<float>(split.first_right_bin));
        const unsigned axis_bit = 1u << split.axis;
        left_count =
            partition(members, sides.left.summary, sides.right.summary, [&](const BuildRef& ref) {
                return (lanes_below(split.map.position(ref), plane) & axis_bit) != 0;
            });
    }
    LRAY_ASSERT(left_count > 0 && left_count < set.count());
    const std::uint32_t middle = set.first + left_count;
    sides.left.first = set.first;
    sides.left.last = middle;
    sides.right.first = middle;
    sides.right.last = set.last;
    return sides;
}

}  // namespace lray::bvh
