// Walking a tree of boxes with one ray: what the walks for each processor and their scalar twin
// have in common. Plain structs and pointers: code compiled for one processor must not emit a
// function that code for another might be linked to.
#pragma once

#include <cstdint>

#include "bvh/boxes/box_layout.h"
#include "bvh/float_ray.h"

namespace lray::bvh {

/// Each node on the way down leaves at most all its children but one waiting.
inline constexpr std::uint32_t kMaxWaiting = kMaxBoxDepth * (kBoxWidth - 1) + 1;

/// What the blocks of spheres and of framed primitives are tested with.
struct BlockRay {
    float unit_dir[3];
    float t_per_length;  // along unit_dir
    float origin_error;  // of the distance of anything from the origin
};

/// Of triangles that the ray may meet, by lane of their block.
struct alignas(32) TriangleFinds {
    float area_a[kBoxWidth];  // twice the signed areas opposite the corners
    float area_b[kBoxWidth];
    float area_c[kBoxWidth];
    float entry[kBoxWidth];  // the stretch of the ray in the triangle's box
    float exit[kBoxWidth];
    float t[kBoxWidth];  // what PlaneHit of kernels/triangle.h holds
    float normal[3][kBoxWidth];
    std::uint32_t grazing;  // a bit for each lane
};

struct Walk;

/// What became of what a walk came upon.
enum class Met : std::uint8_t { nothing, nearer_hit, end };

/// What a walk tells of what the ray may meet. A nearer hit lowers Walk::reach.
struct WalkCalls {
    Met (*meet_triangle)(Walk& walk, const TriangleBlock& block, std::uint32_t lane,
                         const TriangleFinds& finds);
    Met (*meet_sphere)(Walk& walk, const SphereBlock& block, std::uint32_t lane);
    Met (*meet_framed)(Walk& walk, std::uint32_t id);
    Met (*meet_instances)(Walk& walk, const std::uint32_t* ids, std::uint32_t count);
};

/// One ray on its way through one tree.
struct Walk {
    FloatRay* ray;         // of a PreparedRay that set out; walks prepare its floats
    const double* origin;  // the ray in double. Shape: [axis]
    const double* dir;
    const WalkCalls* calls;
    float lo;     // 0 or more
    float reach;  // what is entered beyond it cannot hold a hit that counts: reach_of(hi)
    std::uint64_t node_tests;
    std::uint64_t primitive_tests;
    bool has_block_ray;
    BlockRay block_ray;  // made by the first leaf that needs it
};

/// The most rays that walk together: a bit of 64 each.
inline constexpr std::uint32_t kMaxTileRays = 64;

/// Rays are laid out in whole steps of so many, the most that a vector holds.
inline constexpr std::uint32_t kTileStep = 16;

/// Rays that walk one tree together, because they run close to each other. Shape: [axis][ray]; what
/// stands for no ray is a copy of one that is, with reach kNoReach.
struct alignas(64) Tile {
    float origin[3][kMaxTileRays];
    float dir[3][kMaxTileRays];
    float lo[kMaxTileRays];
    float reach[kMaxTileRays];

    // As in FloatRay, worked out by who walks.
    float origin_near[3][kMaxTileRays];
    float origin_far[3][kMaxTileRays];
    float inv_dir[3][kMaxTileRays];
    float inv_dir_far[3][kMaxTileRays];
    std::uint32_t near_side[3];

    // As in BlockRay; worked out for all rays when the first needs it.
    alignas(64) float unit_dir[3][kMaxTileRays];
    float t_per_length[kMaxTileRays];

    /// Returns the walk of a ray that comes to a leaf, made there and then.
    Walk* (*start)(Tile& tile, std::uint32_t ray);
    Walk* walks[kMaxTileRays];  // null: not started

    std::uint64_t active;  // a bit for each ray; those whose walk was ended are taken out
    std::uint64_t node_tests;
    std::uint64_t primitive_tests;  // beside those of the walks
};

/// The reach of what is no ray, or no more: it is in no box.
inline constexpr float kNoReach = -0x1p127f;

/// Prepares the ray and comes upon everything that the ray meets in front of `lo` and by `reach`.
/// Returns true if a call ended it. nearest: enters the nearest child first. any: in no particular
/// order, for calls that end the walk at the first hit. tile: the same for each ray, a node
/// counting once for all; false if the rays do not all run to the same side of each axis, then
/// nothing was done.
struct Walks {
    bool (*nearest)(const BoxTreeView& tree, Walk& walk);
    bool (*any)(const BoxTreeView& tree, Walk& walk);
    bool (*nearest_tile)(const BoxTreeView& tree, Tile& tile);
    bool (*any_tile)(const BoxTreeView& tree, Tile& tile);
    const char* name;
};

/// Those for the processors that Highway's targets are and that this processor can stand in for,
/// a bit each.
std::int64_t simd_targets();

/// The walks for the best of them; there has to be one.
Walks simd_walks();

}  // namespace lray::bvh
