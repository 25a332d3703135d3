#include "shade/lights/light_table.h"

#include <algorithm>
#include <numbers>
#include <variant>

#include "base/assert.h"

namespace lray::shade {

namespace {

/// Of so many lights the one to follow is chosen by what each is worth at the point.
constexpr std::size_t kFewLights = 64;
/// Of more, this part of the choices is for all alike: what is weak may be near.
constexpr double kEvenShare = 0.5;

float mean(Color color) {
    return (color.r + color.g + color.b) / 3.0f;
}

}  // namespace

LightTable::LightTable(const scene::World& world, const TextureSet& textures) {
    for (const scene::WorldLight& light : world.lights) add(light, world, textures);
    if (entries_.size() > kFewLights) sum_up_power(world);
}

void LightTable::add(const scene::WorldLight& light, const scene::World& world,
                     const TextureSet& textures) {
    const double intensity = light.light.intensity;
    const Color color = light.light.color;
    const auto* const sky = std::get_if<scene::EnvironmentLight>(&light.light.shape);
    const bool shines = intensity > 0.0 && color != Color{0.0f};
    if (!shines && sky == nullptr) return;
    Entry entry;
    entry.casts_shadow = light.casts_shadow;
    entry.luminance = mean(color);
    const auto index = [](const auto& lights) {
        return static_cast<std::uint32_t>(lights.size() - 1);
    };
    bool is_met = false;
    if (sky != nullptr) {
        if (environment_) return;  // the same one, placed twice
        environment_.emplace(world, textures, *sky, color, intensity, light.visible);
        environment_light_ = count();
        entry.kind = Kind::environment;
        entry.sample_count = sky->samples;
        entry.luminance = mean(environment_->mean_radiance());
    } else if (const auto* area = std::get_if<scene::AreaLight>(&light.light.shape)) {
        areas_.push_back(AreaLight::of(*area, color, intensity, light.visible));
        entry.kind = Kind::area;
        entry.index = index(areas_);
        entry.sample_count = area->samples;
        is_met = areas_.back().is_met;
    } else if (const auto* sun = std::get_if<scene::DirectionalLight>(&light.light.shape)) {
        suns_.push_back(SunLight::of(*sun, color, intensity));
        entry.kind = Kind::sun;
        entry.index = index(suns_);
        entry.has_extent = suns_.back().height > 0.0;
        entry.sample_count = entry.has_extent ? sun->samples : 1;
        entry.luminance = mean(suns_.back().irradiance);
    } else if (const auto* point = std::get_if<scene::PointLight>(&light.light.shape)) {
        balls_.push_back(BallLight::of(*point, color, intensity, light.visible));
        entry.index = index(balls_);
        entry.has_extent = point->radius > 0.0;
        entry.sample_count = entry.has_extent ? point->samples : 1;
        is_met = balls_.back().is_met;
    } else {
        const auto& spot = std::get<scene::SpotLight>(light.light.shape);
        balls_.push_back(BallLight::of(spot, color, intensity));
        entry.index = index(balls_);
        entry.has_extent = spot.radius > 0.0;
        entry.sample_count = entry.has_extent ? spot.samples : 1;
    }
    if (is_met) met_.push_back(count());
    entries_.push_back(entry);
}

float LightTable::pdf(std::uint32_t light, DVec3 point, Vec3 normal, Vec3 wi) const {
    const Entry& entry = entries_[light];
    switch (entry.kind) {
        case Kind::ball:
            return balls_[entry.index].pdf(point, wi);
        case Kind::sun:
            return 0.0f;
        case Kind::area:
            return areas_[entry.index].pdf(point, wi);
        case Kind::environment:
            return environment_->pdf(normal, wi);
    }
    return 0.0f;
}

double LightTable::strength_at(const Entry& entry, DVec3 point) const {
    double strength = 1.0;
    switch (entry.kind) {
        case Kind::ball:
            strength = balls_[entry.index].strength_at(point);
            break;
        case Kind::area:
            strength = areas_[entry.index].strength_at(point);
            break;
        case Kind::sun:
        case Kind::environment:
            break;  // it is in their luminance
    }
    return std::min(strength * double{entry.luminance}, kMostLight);
}

/// Light in all, over pi: what falls on a sphere about the light, or of lights from afar on one
/// about the scene.
double LightTable::power(const Entry& entry, double scene_radius) const {
    const double across = scene_radius * scene_radius;
    double power = 0.0;
    switch (entry.kind) {
        case Kind::ball: {
            const BallLight& ball = balls_[entry.index];
            power = ball.strength * 4.0 * std::numbers::pi;
            if (ball.falloff == scene::Falloff::linear) power *= scene_radius;
            if (ball.falloff == scene::Falloff::none) power *= across;
            if (ball.is_spot) power *= 0.5 * (1.0 - ball.cos_rim);
            break;
        }
        case Kind::area:
            power = areas_[entry.index].intensity;
            break;
        case Kind::sun:
            power = std::numbers::pi * across;
            break;
        case Kind::environment:
            power = 4.0 * std::numbers::pi * across;
            break;
    }
    return std::min(power * double{entry.luminance}, kMostLight);
}

void LightTable::sum_up_power(const scene::World& world) {
    const Bounds bounds = scene::finite_bounds(world);
    const double radius =
        bounds.is_empty() ? 1.0 : 0.5 * glm::length(DVec3(bounds.max) - DVec3(bounds.min));
    double total = 0.0;
    for (const Entry& entry : entries_) total += power(entry, radius);
    const double even = kEvenShare / static_cast<double>(entries_.size());
    double sum = 0.0;
    for (const Entry& entry : entries_) {
        sum += even + (1.0 - kEvenShare) * power(entry, radius) / total;
        chosen_.push_back(sum);
    }
}

std::optional<LightTable::Choice> LightTable::choose(DVec3 point, double u) const {
    if (!chosen_.empty()) {
        const double place = u * chosen_.back();
        const auto above = std::upper_bound(chosen_.begin(), chosen_.end() - 1, place);
        const auto light = static_cast<std::uint32_t>(above - chosen_.begin());
        return Choice{light, probability(light, point)};
    }
    double total = 0.0;
    for (const Entry& entry : entries_) total += strength_at(entry, point);
    if (!(total > 0.0)) return std::nullopt;
    const double place = u * total;
    double before = 0.0;
    Choice choice;
    for (std::uint32_t light = 0; light < count(); ++light) {
        const double strength = strength_at(entries_[light], point);
        if (!(strength > 0.0)) continue;
        choice = {light, static_cast<float>(strength / total)};
        before += strength;
        if (place < before) break;
    }
    return choice;
}

float LightTable::probability(std::uint32_t light, DVec3 point) const {
    if (!chosen_.empty()) {
        const double before = light == 0 ? 0.0 : chosen_[light - 1];
        return static_cast<float>((chosen_[light] - before) / chosen_.back());
    }
    double total = 0.0;
    for (const Entry& entry : entries_) total += strength_at(entry, point);
    return total > 0.0 ? static_cast<float>(strength_at(entries_[light], point) / total) : 0.0f;
}

std::optional<LightHit> LightTable::nearest_met(const Ray& ray, Interval interval) const {
    std::optional<LightHit> nearest;
    for (const std::uint32_t light : met_) {
        const Entry& entry = entries_[light];
        const bool is_ball = entry.kind == Kind::ball;
        const std::optional<float> t = is_ball ? balls_[entry.index].hit(ray, interval)
                                               : areas_[entry.index].hit(ray, interval);
        if (!t) continue;
        interval.hi = *t;
        nearest = {*t, is_ball ? balls_[entry.index].radiance() : areas_[entry.index].radiance,
                   light};
    }
    return nearest;
}

std::uint32_t LightTable::most_samples() const {
    std::uint32_t most = 0;
    for (const Entry& entry : entries_) most = std::max(most, entry.sample_count);
    return most;
}

}  // namespace lray::shade
