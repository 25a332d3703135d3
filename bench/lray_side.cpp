#include <algorithm>
#include <new>

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
    if (is_batched_) {
        trace_batches(first, count, counts);
    } else {
        trace_singly(first, count, counts);
    }
    if (!rays_->is_any_hit && !world_.spheres.empty()) add_normals(first, count);
}

void LraySide::trace_singly(std::size_t first, std::size_t count, bvh::TraceCounts& counts) {
    for (std::size_t i = first; i < first + count; ++i) {
        const Ray& ray = rays_->rays[i];
        const Interval interval = rays_->intervals[i];
        if (rays_->is_any_hit) {
            are_hit_[i] = accel_->any_hit(ray, interval, counts);
        } else {
            // In place: what was just written would be waited for by a copy.
            new (&hits_[i]) bvh::Hit(accel_->nearest_hit(ray, interval, counts));
        }
    }
}

void LraySide::trace_batches(std::size_t first, std::size_t count, bvh::TraceCounts& counts) {
    for (std::size_t i = first; i < first + count; i += kTileRays) {
        const std::size_t size = std::min(kTileRays, first + count - i);
        const std::span rays = std::span(rays_->rays).subspan(i, size);
        const std::span intervals = std::span(rays_->intervals).subspan(i, size);
        if (rays_->is_any_hit) {
            accel_->any_hits(rays, intervals, std::span(are_hit_.get() + i, size), counts);
        } else {
            accel_->nearest_hits(rays, intervals, std::span(hits_).subspan(i, size), counts);
        }
    }
}

void LraySide::add_normals(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
        bvh::Hit& hit = hits_[i];
        if (hit.primitive_id.kind() != scene::PrimitiveKind::sphere || hit.is_none()) continue;
        const Ray& ray = rays_->rays[i];
        hit.normal = ray.origin + hit.t * ray.dir - world_.spheres[hit.primitive_id.index()].center;
    }
}

std::vector<float> LraySide::distances() const {
    std::vector<float> result(rays_->size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (rays_->is_any_hit) {
            result[i] = are_hit_[i] ? 0.0f : kInfinity;
        } else {
            result[i] = hits_[i].t;
        }
    }
    return result;
}

}  // namespace lray::bench
