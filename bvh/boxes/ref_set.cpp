#include "bvh/boxes/ref_set.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "bvh/boxes/box_layout.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

namespace {

/// Two sides while they are divided.
struct Sides {
    std::size_t left_count = 0;
    RefSummary left{};
    RefSummary right{};
};

/// Divides in place and sums up both sides on the way.
template <class IsLeft>
Sides partition(std::span<BuildRef> refs, IsLeft is_left) {
    RefSummary left;  // not in the result from the start: these stay in registers
    RefSummary right;
    BuildRef* begin = refs.data();
    BuildRef* end = begin + refs.size();
    while (true) {
        while (begin < end && is_left(*begin)) left.add(*begin++);
        while (begin < end && !is_left(end[-1])) right.add(*--end);
        if (begin >= end) break;
        std::swap(*begin, end[-1]);
        left.add(*begin++);
        right.add(*--end);
    }
    return {static_cast<std::size_t>(begin - refs.data()), left, right};
}

/// References [first, first + count) that are to change places with others.
struct Run {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Swaps those of `a` with those of `b`, in order; both are as many.
void swap_runs(std::span<BuildRef> refs, std::span<const Run> a, std::span<const Run> b) {
    struct Pair {
        std::size_t a = 0;
        std::size_t b = 0;
        std::size_t count = 0;
    };
    std::vector<Pair> pairs;
    std::size_t in_a = 0;  // passed of the first run
    std::size_t in_b = 0;
    while (!a.empty() && !b.empty()) {
        const std::size_t count = std::min(a[0].count - in_a, b[0].count - in_b);
        if (count > 0) pairs.push_back({a[0].first + in_a, b[0].first + in_b, count});
        in_a += count;
        in_b += count;
        if (in_a == a[0].count) {
            a = a.subspan(1);
            in_a = 0;
        }
        if (in_b == b[0].count) {
            b = b.subspan(1);
            in_b = 0;
        }
    }
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
        BuildRef* const from = refs.data() + pairs[i].a;
        std::swap_ranges(from, from + pairs[i].count, refs.data() + pairs[i].b);
    });
}

/// The same on all cores: each share is divided on its own, then what stands on the wrong side of
/// the whole changes places.
template <class IsLeft>
Sides partition_in_shares(std::span<BuildRef> refs, IsLeft is_left) {
    std::vector<Sides> shares((refs.size() + kShare - 1) / kShare);
    const auto share_of = [&](std::size_t i) {
        return refs.subspan(i * kShare, std::min(kShare, refs.size() - i * kShare));
    };
    tbb::parallel_for(std::size_t{0}, shares.size(),
                      [&](std::size_t i) { shares[i] = partition(share_of(i), is_left); });
    Sides sides;
    for (const Sides& share : shares) {
        sides.left_count += share.left_count;
        sides.left.add(share.left);
        sides.right.add(share.right);
    }
    std::vector<Run> misplaced_right;
    std::vector<Run> misplaced_left;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const std::size_t first = i * kShare;
        const std::size_t middle = first + shares[i].left_count;
        const std::size_t last = first + share_of(i).size();
        if (middle < sides.left_count) {
            misplaced_right.push_back({middle, std::min(last, sides.left_count) - middle});
        }
        if (middle > sides.left_count) {
            const std::size_t from = std::max(first, sides.left_count);
            misplaced_left.push_back({from, middle - from});
        }
    }
    swap_runs(refs, misplaced_right, misplaced_left);
    return sides;
}

template <class IsLeft>
Sides partition_set(std::span<BuildRef> refs, IsLeft is_left) {
    return refs.size() < kParallelCount ? partition(refs, is_left)
                                        : partition_in_shares(refs, is_left);
}

TwoSets divide_in_middle(std::span<BuildRef> refs, const RefSet& set) {
    // Blocks on the left are full.
    const std::uint32_t half = (set.count() / 2 + kBoxWidth - 1) / kBoxWidth * kBoxWidth;
    const std::uint32_t left_count = half < set.count() ? half : set.count() / 2;
    const std::uint32_t middle = set.first + left_count;
    return share_room(refs, set, left_count, summarize(refs.subspan(set.first, left_count)),
                      summarize(refs.subspan(middle, set.last - middle)));
}

}  // namespace

BinMap make_bin_map(const Box4& range, int bin_count) {
    float extent[4];
    store_four(extent, range.upper - range.lower);
    float scale[3];
    for (int axis = 0; axis < 3; ++axis) {
        // The last bin ends a little behind the range. Where the quotient is not a number of use,
        // all comes to lie in one bin.
        const float wanted = static_cast<float>(bin_count) * 0.99999f / extent[axis];
        scale[axis] =
            extent[axis] > 0.0f && wanted < std::numeric_limits<float>::max() ? wanted : 0.0f;
    }
    return {range.lower, Float4::of(scale[0], scale[1], scale[2]), bin_count};
}

RefSummary summarize(std::span<const BuildRef> refs) {
    const auto add = [refs](const tbb::blocked_range<std::size_t>& range, RefSummary summary) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) summary.add(refs[i]);
        return summary;
    };
    const tbb::blocked_range<std::size_t> all(0, refs.size(), kShare);
    if (refs.size() < kParallelCount) return add(all, {});
    return tbb::parallel_reduce(all, RefSummary{}, add, [](RefSummary a, const RefSummary& b) {
        a.add(b);
        return a;
    });
}

TwoSets share_room(std::span<BuildRef> refs, const RefSet& set, std::uint32_t left_count,
                   const RefSummary& left, const RefSummary& right) {
    const std::uint32_t middle = set.first + left_count;
    std::uint32_t left_room = 0;
    if (set.end > set.last) {
        const double of_left = half_area(left.box) * left_count;
        const double of_right = half_area(right.box) * (set.last - middle);
        const double share = of_left + of_right > 0.0 ? of_left / (of_left + of_right) : 0.0;
        left_room = static_cast<std::uint32_t>(share * (set.end - set.last));
        // The order on the right is no matter: as few as need to make way.
        const std::uint32_t moved = std::min(left_room, set.last - middle);
        std::copy_n(refs.begin() + middle, moved, refs.begin() + set.last + left_room - moved);
    }
    return {{set.first, middle, middle + left_room, left},
            {middle + left_room, set.last + left_room, set.end, right}};
}

TwoSets divide(std::span<BuildRef> refs, const RefSet& set, const Split& split) {
    LRAY_ASSERT(split.kind != SplitKind::none && split.kind != SplitKind::cut && set.count() >= 2);
    if (split.kind == SplitKind::middle) return divide_in_middle(refs, set);
    const std::span<BuildRef> members = refs.subspan(set.first, set.count());
    Sides sides;
    if (split.kind == SplitKind::by_class) {
        const auto first_class = static_cast<unsigned>(std::countr_zero(set.summary.classes));
        sides = partition_set(members,
                              [&](const BuildRef& ref) { return ref.ref_class() == first_class; });
    } else {
        const auto plane = static_cast<float>(split.first_right_bin);
        const int axis = split.axis;
        const float origin = lane(split.map.origin, axis);
        const float scale = lane(split.map.scale, axis);
        sides = partition_set(members, [=](const BuildRef& ref) {
            // As BinMap::position(), to the bit; NaN is in the first bin.
            return !((ref.min[axis] + ref.max[axis] - origin) * scale >= plane);
        });
    }
    LRAY_ASSERT(sides.left_count > 0 && sides.left_count < set.count());
    return share_room(refs, set, static_cast<std::uint32_t>(sides.left_count), sides.left,
                      sides.right);
}

}  // namespace lray::bvh
