#include <algorithm>
#include <array>

#include "bench/trace_side.h"

namespace lray::bench {

std::string LraySide::name() const {
    return options_.kind == bvh::AccelKind::spheres ? "lray spheres" : "lray boxes";
}

void LraySide::build() {
    accel_ = bvh::build(world_, options_);
}

void LraySide::clear() {
    accel_.reset();
}

std::size_t LraySide::bytes() const {
    return accel_->stats().bytes;
}

void LraySide::load(const RaySet& rays) {
    rays_ = &rays;
    if (rays.is_any_hit) {
        are_hit_ = std::make_unique<bool[]>(rays.size());
    } else {
        hits_.assign(rays.size(), {});
    }
}

void LraySide::trace() {
    trace(0, rays_->size());
}

void LraySide::trace(std::size_t first, std::size_t count) {
    bvh::TraceCounts counts;
    const std::span rays = std::span(rays_->rays).subspan(first, count);
    const std::span intervals = std::span(rays_->intervals).subspan(first, count);
    if (!is_batched_ && rays_->is_any_hit) {
        for (std::size_t i = 0; i < count; ++i) {
            are_hit_[first + i] = accel_->any_hit(rays[i], intervals[i], counts);
        }
        return;
    }
    if (!is_batched_) {
        for (std::size_t i = 0; i < count; ++i) {
            const bvh::Hit hit = accel_->nearest_hit(rays[i], intervals[i], counts);
            hits_[first + i] = {hit, normal_at(rays[i], hit)};
        }
        return;
    }
    std::array<bvh::Hit, kTileRays> found{};
    for (std::size_t i = 0; i < count; i += kTileRays) {
        const std::size_t size = std::min(kTileRays, count - i);
        const std::span batch = rays.subspan(i, size);
        const std::span batch_intervals = intervals.subspan(i, size);
        if (rays_->is_any_hit) {
            const std::span are_hit(are_hit_.get() + first + i, size);
            accel_->any_hits(batch, batch_intervals, are_hit, counts);
            continue;
        }
        const std::span hits = std::span(found).first(size);
        accel_->nearest_hits(batch, batch_intervals, hits, counts);
        for (std::size_t k = 0; k < size; ++k) {
            hits_[first + i + k] = {hits[k], normal_at(batch[k], hits[k])};
        }
    }
}

/// The normal is a part of Embree's hit: what it costs is counted on both sides.
Vec3 LraySide::normal_at(const Ray& ray, const bvh::Hit& hit) const {
    if (hit.is_none()) return Vec3{0.0f};
    const std::size_t index = hit.primitive_id.index();
    if (hit.primitive_id.kind() == scene::PrimitiveKind::sphere) {
        return ray.origin + hit.t * ray.dir - world_.spheres[index].center;
    }
    return hit.normal;
}

std::vector<float> LraySide::distances() const {
    std::vector<float> result(rays_->size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (rays_->is_any_hit) {
            result[i] = are_hit_[i] ? 0.0f : kInfinity;
        } else {
            result[i] = hits_[i].hit.t;
        }
    }
    return result;
}

}  // namespace lray::bench
