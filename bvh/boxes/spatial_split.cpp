#include "bvh/boxes/spatial_split.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "base/assert.h"
#include "bvh/boxes/clip_triangle.h"

namespace lray::bvh {

namespace {

/// Bins of sets of kManyRefs and more; smaller ones have half as many.
constexpr std::size_t kBinCount = 16;
constexpr std::uint32_t kManyRefs = 128;

/// The stretch between two planes of an axis: what of the references is in it, and the weight of
/// those that begin and end in it.
struct Bin {
    Box4 box{};
    std::uint64_t begun = 0;
    std::uint64_t ended = 0;
    std::uint32_t begun_count = 0;
    std::uint32_t ended_count = 0;
};

struct Bins {
    std::array<std::array<Bin, kBinCount>, 3> by_axis{};

    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < kBinCount; ++i) {
                Bin& bin = by_axis[axis][i];
                const Bin& more = other.by_axis[axis][i];
                bin.box.add(more.box);
                bin.begun += more.begun;
                bin.ended += more.ended;
                bin.begun_count += more.begun_count;
                bin.ended_count += more.ended_count;
            }
        }
    }
};

/// The bins that a reference reaches over in each axis. Both sides of a plane have to be told apart
/// by this alone.
struct Reach {
    int first[4];
    int last[4];

    Reach(const BuildRef& ref, const BinMap& map) {
        const Float4 most = Float4::fill(static_cast<float>(map.bin_count - 1));
        const auto bins_at = [&](Float4 point, int* bins) {
            const Float4 position = (point - map.origin) * map.scale;
            store_whole(bins, min(max(position, Float4::fill(0.0f)), most));
        };
        if (ref.ref_class() == static_cast<unsigned>(RefClass::triangle)) {
            bins_at(ref.lower(), first);
            bins_at(ref.upper(), last);
        } else {
            bins_at((ref.lower() + ref.upper()) * Float4::fill(0.5f), first);
            for (int axis = 0; axis < 3; ++axis) last[axis] = first[axis];
        }
    }
};

Float4 as_float4(Vec3 p) {
    return Float4::of(p.x, p.y, p.z);
}

/// A triangle, and where its corners lie among the bins.
struct BinnedCorners {
    std::array<Float4, 3> points;
    float positions[3][4];

    BinnedCorners(const scene::Geometry& geometry, const BuildRef& ref, const BinMap& map) {
        const RefCorners corners = corners_of(geometry, ref);
        points = {as_float4(corners.a), as_float4(corners.b), as_float4(corners.c)};
        for (std::size_t i = 0; i < 3; ++i) {
            store_four(positions[i], (points[i] - map.origin) * map.scale);
        }
    }
};

/// Adds to the bins [first, last] of an axis what of a triangle is in each, as far as it is in the
/// box of the reference. For costs alone, thus in float and without the pad of part_of().
void add_parts(std::array<Bin, kBinCount>& row, const BuildRef& ref, const BinnedCorners& corners,
               int axis, int first, int last) {
    std::array<Box4, kBinCount> parts;
    const auto part = [&](int bin) -> Box4& { return parts[static_cast<std::size_t>(bin)]; };
    for (int bin = first; bin <= last; ++bin) part(bin) = {};
    const auto bin_at = [&](float position) {
        const float least = static_cast<float>(first);
        const float most = static_cast<float>(last);
        return static_cast<int>(position > least ? (position < most ? position : most) : least);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const Float4 a = corners.points[i];
        const Float4 b = corners.points[next];
        const float from = corners.positions[i][axis];
        const float to = corners.positions[next][axis];
        const int from_bin = bin_at(from);
        const int to_bin = bin_at(to);
        part(from_bin).add(a, a);
        const int last_plane = std::max(from_bin, to_bin);
        for (int plane = std::min(from_bin, to_bin) + 1; plane <= last_plane; ++plane) {
            const float share = (static_cast<float>(plane) - from) / (to - from);
            const Float4 point = a + (b - a) * Float4::fill(share);
            part(plane - 1).add(point, point);
            part(plane).add(point, point);
        }
    }
    const Float4 lower = ref.lower();
    const Float4 upper = ref.upper();
    for (int bin = first; bin <= last; ++bin) {
        const Float4 low = max(part(bin).lower, lower);
        const Float4 high = min(part(bin).upper, upper);
        if ((lanes_below(high, low) & 7) == 0)
            row[static_cast<std::size_t>(bin)].box.add(low, high);
    }
}

void add_ref(Bins& bins, const scene::Geometry& geometry, const BuildRef& ref, const BinMap& map) {
    const Reach reach(ref, map);
    const std::uint32_t weight = kRefWeights[ref.ref_class()];
    std::optional<BinnedCorners> corners;
    for (int axis = 0; axis < 3; ++axis) {
        auto& row = bins.by_axis[static_cast<std::size_t>(axis)];
        Bin& first = row[static_cast<std::size_t>(reach.first[axis])];
        Bin& last = row[static_cast<std::size_t>(reach.last[axis])];
        first.begun += weight;
        ++first.begun_count;
        last.ended += weight;
        ++last.ended_count;
        if (reach.first[axis] == reach.last[axis]) {
            first.box.add(ref.lower(), ref.upper());
        } else {
            if (!corners) corners.emplace(geometry, ref, map);
            add_parts(row, ref, *corners, axis, reach.first[axis], reach.last[axis]);
        }
    }
}

Bins fill(const scene::Geometry& geometry, std::span<const BuildRef> refs, const BinMap& map) {
    const auto add = [&](const tbb::blocked_range<std::size_t>& range, Bins bins) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            add_ref(bins, geometry, refs[i], map);
        }
        return bins;
    };
    const tbb::blocked_range<std::size_t> all(0, refs.size(), kShare / 16);
    if (refs.size() < kParallelCount / 16) return add(all, {});
    return tbb::parallel_reduce(all, Bins{}, add, [](Bins a, const Bins& b) {
        a.add(b);
        return a;
    });
}

double plane_of(const Split& split) {
    float origin[4];
    float scale[4];
    store_four(origin, split.map.origin);
    store_four(scale, split.map.scale);
    LRAY_ASSERT(scale[split.axis] > 0.0f);  // there is more than one bin
    return static_cast<double>(origin[split.axis]) +
           split.first_right_bin / static_cast<double>(scale[split.axis]);
}

}  // namespace

Split find_cut(const scene::Geometry& geometry, std::span<const BuildRef> refs, const RefSet& set,
               const Measure& measure) {
    const std::size_t bin_count = set.count() < kManyRefs ? kBinCount / 2 : kBinCount;
    Split best;
    best.cost = std::numeric_limits<double>::infinity();
    best.map = make_bin_map(set.summary.box, static_cast<int>(bin_count));
    const Bins bins = fill(geometry, refs.subspan(set.first, set.count()), best.map);
    const std::uint64_t most_refs = set.count() + std::uint64_t{set.end - set.last};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& row = bins.by_axis[axis];
        std::array<double, kBinCount> right_cost{};
        std::array<std::uint64_t, kBinCount> right_count{};
        Box4 box;
        std::uint64_t weight = 0;
        std::uint64_t count = 0;
        for (std::size_t i = bin_count; i-- > 1;) {
            box.add(row[i].box);
            weight += row[i].ended;
            count += row[i].ended_count;
            right_cost[i] = count > 0 ? measure(box) * block_count(weight)
                                      : std::numeric_limits<double>::infinity();
            right_count[i] = count;
        }
        box = {};
        weight = 0;
        count = 0;
        for (std::size_t i = 1; i < bin_count; ++i) {
            box.add(row[i - 1].box);
            weight += row[i - 1].begun;
            count += row[i - 1].begun_count;
            if (count == 0 || count + right_count[i] > most_refs) continue;
            const double cost = measure(box) * block_count(weight) + right_cost[i];
            if (cost < best.cost) {
                best.cost = cost;
                best.kind = SplitKind::cut;
                best.axis = static_cast<int>(axis);
                best.first_right_bin = static_cast<int>(i);
            }
        }
    }
    return best;
}

TwoSets divide_by_cut(const scene::Geometry& geometry, std::span<BuildRef> refs, const RefSet& set,
                      const Split& split) {
    const int axis = split.axis;
    const double plane = plane_of(split);
    constexpr double kFar = std::numeric_limits<double>::infinity();
    RefSummary left;
    RefSummary right;
    RefSet whole = set;  // with the parts that are made
    std::uint32_t next = set.first;
    std::uint32_t right_first = set.last;
    while (next < right_first) {
        BuildRef& ref = refs[next];
        const Reach reach(ref, split.map);
        bool is_left = reach.first[axis] < split.first_right_bin;
        if (is_left && reach.last[axis] >= split.first_right_bin) {
            const BuildRef left_part = part_of(geometry, ref, axis, -kFar, plane);
            const BuildRef right_part = part_of(geometry, ref, axis, plane, kFar);
            is_left = !is_empty(left_part);
            if (is_left && !is_empty(right_part)) {
                LRAY_ASSERT(whole.last < set.end);
                refs[whole.last++] = right_part;
                right.add(right_part);
                ref = left_part;
            }
        }
        if (is_left) {
            left.add(refs[next++]);
        } else {
            right.add(ref);
            std::swap(ref, refs[--right_first]);
        }
    }
    return share_room(refs, whole, next - set.first, left, right);
}

}  // namespace lray::bvh
