// What trace_speed measures: one hierarchy over a world, lray's or Embree's.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/trace_rays.h"
#include "bvh/accel.h"
#include "scene/world.h"

namespace lray::bench {

class TraceSide {
 public:
    virtual ~TraceSide() = default;

    virtual std::string name() const = 0;

    /// Builds the hierarchy on the threads that oneTBB may use; it had none or was cleared.
    virtual void build() = 0;
    virtual void clear() = 0;

    /// Returns what is kept for tracing beside the vertices and indices.
    virtual std::size_t bytes() const = 0;

    /// Brings the rays into the form that this side takes them in. They must outlive the tracing.
    virtual void load(const RaySet& rays) = 0;

    /// Finds the hits of all loaded rays, which are loaded anew for each time.
    virtual void trace() = 0;

    /// Returns t of each hit, for any hit 0; infinity where nothing was hit.
    virtual std::vector<float> distances() const = 0;
};

/// lray's side, which also gives the hits that other rays start from.
class LraySide : public TraceSide {
 public:
    LraySide(const scene::World& world, const bvh::BuildOptions& options, bool is_batched)
        : world_(world), options_(options), is_batched_(is_batched) {}

    std::string name() const override;
    void build() override;
    void clear() override;
    std::size_t bytes() const override;
    void load(const RaySet& rays) override;
    void trace() override;
    std::vector<float> distances() const override;

    /// Traces a stretch of the loaded rays. Different stretches may be traced at the same time.
    void trace(std::size_t first, std::size_t count);

    /// Shape: one for each loaded ray, which were not for any hit. Those of spheres have normals,
    /// too: they are a part of Embree's hits, and what they cost is counted on both sides.
    std::span<const bvh::Hit> hits() const { return hits_; }

 private:
    void trace_singly(std::size_t first, std::size_t count, bvh::TraceCounts& counts);
    void trace_batches(std::size_t first, std::size_t count, bvh::TraceCounts& counts);
    void add_normals(std::size_t first, std::size_t count);

    const scene::World& world_;
    bvh::BuildOptions options_{};
    bool is_batched_ = false;
    std::unique_ptr<bvh::Accel> accel_{};
    const RaySet* rays_ = nullptr;
    std::vector<bvh::Hit> hits_{};
    std::unique_ptr<bool[]> are_hit_{};
};

/// Returns Embree's sides: with the plain flags and the robust one. None where it was not found.
std::vector<std::unique_ptr<TraceSide>> make_embree_sides(const scene::World& world,
                                                          bvh::BuildQuality quality,
                                                          bool is_batched);

}  // namespace lray::bench
