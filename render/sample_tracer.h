// Samples of a few pixels: their rays, what they hit, its colour, onto a film.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "base/ray.h"
#include "base/sampler.h"
#include "bvh/accel.h"
#include "render/camera_rays.h"
#include "render/film.h"
#include "render/options.h"
#include "render/ray_counts.h"
#include "scene/camera.h"
#include "scene/world.h"
#include "shade/shader.h"
#include "shade/transport/follow_light.h"

namespace lray::render {

/// A pixel of a film.
struct FilmPlace {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

/// What all samples of a view have in common. Const calls are thread-safe. The world and the
/// hierarchy must outlive it.
class SampleTracer {
 public:
    /// Traces already: once `cancel` is set it is of no use.
    SampleTracer(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                 const RenderOptions& options, const std::atomic<bool>& cancel);

    /// From now on no light is given more samples at a point (shade::Settings).
    void limit_light_samples(std::uint32_t count) { options_.shading.max_light_samples = count; }

    /// Adds samples of some pixels of a part of the full picture to a film of its size, one of each
    /// pixel after the other, and their cost to `counts`. Returns how many it added: fewer than all
    /// once `cancel` is set. Shape: `places` lie on the film, in any order.
    std::uint64_t add_samples(const PixelRect& part, std::span<const FilmPlace> places,
                              SampleRange samples, Film& film, RayCounts& counts,
                              const std::atomic<bool>& cancel) const;

    /// Works out the colour of one sample of each of some pixels of the full picture, and adds its
    /// cost to `counts`. Shape: of the same length. Errors: false once `cancel` is set: then the
    /// colours mean nothing.
    bool colors_of(std::span<const FilmPlace> pixels, std::uint32_t index, std::span<Color> colors,
                   RayCounts& counts, const std::atomic<bool>& cancel) const;

 private:
    struct Batch;

    /// Adds the ray of a sample of a pixel of the full picture.
    void add_ray(Batch& batch, std::uint32_t x, std::uint32_t y, std::uint32_t index) const;

    /// Works out the colours of a batch, and adds their cost; false once `cancel` is set.
    bool finish(Batch& batch, RayCounts& counts, const std::atomic<bool>& cancel) const;

    /// Finds what the rays of a batch hit; returns what that cost.
    bvh::TraceCounts trace(Batch& batch, const std::atomic<bool>& cancel) const;

    bool shade(Batch& batch, shade::LightCounts& counts, const std::atomic<bool>& cancel) const;
    PixelSample pixel_sample(std::uint32_t x, std::uint32_t y, std::uint32_t index) const;
    Ray camera_ray(std::uint32_t x, std::uint32_t y, const PixelSample& sample) const;
    shade::RayCone pixel_cone(std::uint32_t x, std::uint32_t y) const;

    const bvh::Accel& accel_;
    CameraRays rays_;
    RenderOptions options_;
    shade::ShadeInput shading_;
    shade::Media camera_media_{};
};

}  // namespace lray::render
