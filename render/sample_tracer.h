// Samples of a few pixels: their rays, what they hit, its colour, onto a film.
#pragma once

#include <atomic>
#include <cstdint>

#include "bvh/accel.h"
#include "render/camera_rays.h"
#include "render/film.h"
#include "render/options.h"
#include "scene/camera.h"
#include "scene/world.h"
#include "shade/shader.h"
#include "shade/transport/follow_light.h"

namespace lray::render {

/// What the rays of samples cost.
struct RayCounts {
    bvh::TraceCounts primary{};  // from the camera
    shade::LightCounts light{};  // of full shading

    RayCounts& operator+=(const RayCounts& other) {
        primary += other.primary;
        light += other.light;
        return *this;
    }
};

/// What all samples of a view have in common. Const calls are thread-safe. The world and the
/// hierarchy must outlive it.
class SampleTracer {
 public:
    SampleTracer(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                 const RenderOptions& options);

    /// Adds one sample of each pixel of a part of the full picture to a film of its size, row by
    /// row, and their cost to `counts`. Returns how many it added: fewer than all once `cancel` is
    /// set.
    std::uint32_t add_sample(const PixelRect& part, std::uint32_t sample, Film& film,
                             RayCounts& counts, const std::atomic<bool>& cancel) const;

 private:
    struct Batch;

    /// Works out the colours of a batch; false once `cancel` is set.
    bool shade(Batch& batch, std::size_t size, shade::LightCounts& counts,
               const std::atomic<bool>& cancel) const;

    const bvh::Accel& accel_;
    CameraRays rays_;
    RenderOptions options_;
    shade::ShadeInput shading_;
    shade::Media camera_media_{};
};

}  // namespace lray::render
