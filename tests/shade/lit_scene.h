// Scenes in the language, lit and looked at one ray at a time.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "bvh/accel.h"
#include "scene/scene.h"
#include "scene/world.h"
#include "shade/transport/follow_light.h"

namespace lray::test {

/// A scene that must be right: a mistake in it fails the test and throws.
class LitScene {
 public:
    explicit LitScene(std::string_view text, bvh::AccelKind kind = bvh::AccelKind::boxes);

    /// The settings of its `render` block, with full shading; a test may change them.
    shade::Settings settings{};

    const scene::World& world() const { return *world_; }
    const shade::LitWorld& lit() const { return *lit_; }

    /// Returns the light that comes along a ray (its direction is made unit) as seen by one sample.
    Color seen(DVec3 origin, DVec3 direction, std::uint32_t sample = 0) const;

    /// Returns the mean of the samples from 0.
    DVec3 mean(DVec3 origin, DVec3 direction, std::uint32_t sample_count) const;

    shade::LightCounts counts() const { return counts_; }

 private:
    Sources sources_{};
    Diagnostics diagnostics_{};
    std::optional<scene::Scene> scene_{};
    std::optional<scene::World> world_{};
    std::unique_ptr<bvh::Accel> accel_{};
    std::unique_ptr<shade::LitWorld> lit_{};
    mutable shade::LightCounts counts_{};
};

}  // namespace lray::test
