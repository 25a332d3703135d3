// A stretch of references on its way to become a subtree, and how such a stretch is divided.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "bvh/boxes/build_refs.h"

namespace lray::bvh {

/// The box [lower, upper]; empty when made by default. NaN is left out, in any order: the middle of
/// a box that reaches to infinity on both sides.
struct Box4 {
    Float4 lower = Float4::fill(kInfinity);
    Float4 upper = Float4::fill(-kInfinity);

    void add(Float4 low, Float4 high) {
        lower = min(low, lower);
        upper = max(high, upper);
    }
    void add(const Box4& other) { add(other.lower, other.upper); }
};

/// What is known of references before they are divided.
struct RefSummary {
    Box4 box{};
    Box4 centers{};             // of the boxes, times two
    std::uint32_t classes = 0;  // a bit for each RefClass among them

    void add(const BuildRef& ref) {
        const Float4 low = ref.lower();
        const Float4 high = ref.upper();
        const Float4 center = low + high;
        box.add(low, high);
        centers.add(center, center);
        classes |= 1u << ref.ref_class();
    }
    void add(const RefSummary& other) {
        box.add(other.box);
        centers.add(other.centers);
        classes |= other.classes;
    }
    bool is_of_one_class() const { return std::has_single_bit(classes); }
    RefClass only_class() const { return static_cast<RefClass>(std::countr_zero(classes)); }
};

/// The references [first, last) of the array that a tree is built in; up to `end` it is room for
/// more.
struct RefSet {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t end = 0;
    RefSummary summary{};

    std::uint32_t count() const { return last - first; }
};

/// From so many references on, a set is gone through by several tasks. Their shares are of a fixed
/// size, so that the result does not depend on the number of cores.
inline constexpr std::uint32_t kParallelCount = 1u << 16;
inline constexpr std::size_t kShare = 1u << 14;

/// Sums up references.
RefSummary summarize(std::span<const BuildRef> refs);

/// Equally wide bins of each axis: those of centres are of centres times two.
struct BinMap {
    Float4 origin{};
    Float4 scale{};
    int bin_count = 0;

    Float4 position(const BuildRef& ref) const {
        return (ref.lower() + ref.upper() - origin) * scale;
    }
};

BinMap make_bin_map(const Box4& range, int bin_count);

enum class SplitKind : std::uint8_t {
    none,      // it becomes a leaf
    bins,      // by the bins of the centres
    cut,       // by the bins of the boxes, and what is in both is cut in two
    by_class,  // the first class of those there from the others
    middle,    // by place in the array, half each
};

/// How a set is to be divided.
struct Split {
    double cost = 0.0;  // of both sides, in tests of blocks times area
    SplitKind kind = SplitKind::none;
    int axis = 0;
    int first_right_bin = 0;
    BinMap map{};
};

struct TwoSets {
    RefSet left{};
    RefSet right{};
};

/// Brings what goes left to the front, except for a SplitKind::cut. Neither side is empty.
TwoSets divide(std::span<BuildRef> refs, const RefSet& set, const Split& split);

/// Shares the room behind a divided set between its sides, by how many they are and how large: a
/// cut high up saves most.
TwoSets share_room(std::span<BuildRef> refs, const RefSet& set, std::uint32_t left_count,
                   const RefSummary& left, const RefSummary& right);

}  // namespace lray::bvh
