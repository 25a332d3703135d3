#include "bvh/boxes/binned_split.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <limits>

#include "bvh/boxes/spatial_split.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

namespace {

constexpr int kMaxBinCount = 32;

/// Cuts are tried where both sides share so much of the set's area. At half of that the trees are
/// no better, and take half as long again.
constexpr double kLeastOverlap = 0.2;

/// One bin of each axis.
struct Bin {
    Box4 box;
    std::uint64_t weight;
};

/// The first `count` of each axis are in use.
struct Bins {
    std::array<std::array<Bin, kMaxBinCount>, 3> by_axis;

    explicit Bins(int count) {
        for (auto& bins : by_axis) std::fill_n(bins.begin(), count, Bin{{}, 0});
    }
    std::array<Bin, kMaxBinCount>& operator[](std::size_t axis) { return by_axis[axis]; }
    const std::array<Bin, kMaxBinCount>& operator[](std::size_t axis) const {
        return by_axis[axis];
    }
};

int bin_count_for(std::uint32_t ref_count, BuildQuality quality) {
    const int most = quality == BuildQuality::low ? 16 : kMaxBinCount;
    const int wanted = ref_count < 64 ? 8 : (ref_count < 1024 ? 16 : 32);
    return wanted < most ? wanted : most;
}

void fill(Bins& bins, std::span<const BuildRef> refs, const BinMap& map) {
    const Float4 last = Float4::fill(static_cast<float>(map.bin_count - 1));
    const Float4 zero = Float4::fill(0.0f);
    const auto add = [&](const BuildRef& ref) {
        int index[4];
        store_whole(index, min(max(map.position(ref), zero), last));
        const Float4 low = ref.lower();
        const Float4 high = ref.upper();
        const std::uint32_t weight = kRefWeights[ref.ref_class()];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[axis][static_cast<std::size_t>(index[axis])];
            bin.box.add(low, high);
            bin.weight += weight;
        }
    };
    // From two places at once: neighbours tend to be in the same bin, and would wait for each
    // other.
    const std::size_t half = refs.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
        add(refs[i]);
        add(refs[half + i]);
    }
    if (refs.size() % 2 != 0) add(refs.back());
}

void fill_in_shares(Bins& bins, std::span<const BuildRef> refs, const BinMap& map) {
    bins = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, refs.size(), kShare), bins,
        [&](const tbb::blocked_range<std::size_t>& range, Bins some) {
            fill(some, refs.subspan(range.begin(), range.size()), map);
            return some;
        },
        [&](Bins a, const Bins& b) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (std::size_t i = 0; i < static_cast<std::size_t>(map.bin_count); ++i) {
                    a[axis][i].box.add(b[axis][i].box);
                    a[axis][i].weight += b[axis][i].weight;
                }
            }
            return a;
        });
}

/// Finds the cheapest plane between two bins.
Split sweep(const Bins& bins, const BinMap& map, const Measure& measure) {
    Split best;
    best.cost = std::numeric_limits<double>::infinity();
    best.map = map;
    const auto bin_count = static_cast<std::size_t>(map.bin_count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, kMaxBinCount> right_cost{};
        Box4 box;
        std::uint64_t weight = 0;
        for (std::size_t i = bin_count; i-- > 1;) {
            box.add(bins[axis][i].box);
            weight += bins[axis][i].weight;
            right_cost[i] = weight > 0 ? measure(box) * block_count(weight)
                                       : std::numeric_limits<double>::infinity();
        }
        box = {};
        weight = 0;
        for (std::size_t i = 1; i < bin_count; ++i) {
            const Bin& bin = bins[axis][i - 1];
            box.add(bin.box);
            weight += bin.weight;
            if (weight == 0) continue;
            const double cost = measure(box) * block_count(weight) + right_cost[i];
            if (cost < best.cost) {
                best.cost = cost;
                best.kind = SplitKind::bins;
                best.axis = static_cast<int>(axis);
                best.first_right_bin = static_cast<int>(i);
            }
        }
    }
    return best;
}

/// The size of what the boxes of both sides share.
double overlap_of_sides(const Bins& bins, const Split& split, const Measure& measure) {
    const auto& row = bins[static_cast<std::size_t>(split.axis)];
    Box4 left;
    Box4 right;
    for (int i = 0; i < split.map.bin_count; ++i) {
        (i < split.first_right_bin ? left : right).add(row[static_cast<std::size_t>(i)].box);
    }
    const Box4 shared{max(left.lower, right.lower), min(left.upper, right.upper)};
    float extent[4];
    store_four(extent, shared.upper - shared.lower);
    const bool is_shared = extent[0] >= 0.0f && extent[1] >= 0.0f && extent[2] >= 0.0f;
    return is_shared ? measure(shared) : 0.0;
}

std::uint64_t weight_of(std::span<const BuildRef> refs, const RefSet& set) {
    if (set.summary.is_of_one_class()) {
        const auto ref_class = static_cast<std::size_t>(set.summary.only_class());
        return std::uint64_t{set.count()} * kRefWeights[ref_class];
    }
    std::uint64_t weight = 0;
    for (const BuildRef& ref : refs.subspan(set.first, set.count())) {
        weight += kRefWeights[ref.ref_class()];
    }
    return weight;
}

}  // namespace

bool can_be_leaf(const RefSet& set) {
    if (!set.summary.is_of_one_class()) return false;
    const bool is_in_blocks = has_blocks(set.summary.only_class());
    return set.count() <= (is_in_blocks ? kMaxLeafCount * kBoxWidth : kMaxLeafCount);
}

Split find_split(const SplitRules& rules, std::span<const BuildRef> refs, const RefSet& set) {
    const bool is_of_one_class = set.summary.is_of_one_class();
    if (is_of_one_class && (set.count() == 1 || weight_of(refs, set) <= kBoxWidth)) return {};
    const Measure& measure = rules.measure;
    const double size = measure(set.summary.box);
    const BinMap map = make_bin_map(set.summary.centers, bin_count_for(set.count(), rules.quality));
    const std::span<const BuildRef> members = refs.subspan(set.first, set.count());
    Bins bins(map.bin_count);
    if (members.size() < kParallelCount) {
        fill(bins, members, map);
    } else {
        fill_in_shares(bins, members, map);
    }
    Split best = sweep(bins, map, measure);
    if (rules.quality == BuildQuality::high && set.end > set.last && best.kind == SplitKind::bins &&
        overlap_of_sides(bins, best, measure) >= kLeastOverlap * size) {
        const Split cut = find_cut(rules.geometry, refs, set, measure);
        if (cut.cost < best.cost) best = cut;
    }
    const double leaf_cost = size * block_count(weight_of(refs, set));
    if (!(best.cost < leaf_cost)) {
        if (can_be_leaf(set)) return {};
        // The kinds have to part some time.
        if (!is_of_one_class && set.count() <= kMaxLeafCount * kBoxWidth) {
            best.kind = SplitKind::by_class;
            best.cost = leaf_cost;
        }
    }
    if (best.kind == SplitKind::none || !(size > 0.0)) {
        best.kind = is_of_one_class ? SplitKind::middle : SplitKind::by_class;
        best.cost = leaf_cost;
    }
    return best;
}

}  // namespace lray::bvh
