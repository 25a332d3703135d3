#include "bvh/brute_force.h"

#include <array>
#include <utility>
#include <vector>

#include "bvh/kernels/kernels.h"

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

/// Consecutive primitives of one kind: [first, last).
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
};
using RunsByKind = std::array<std::vector<Run>, scene::kPrimitiveKindCount>;

/// Returns the primitives whose object `is_wanted`, as few runs as possible: scenes rarely hide
/// anything, and the loops need no look at the objects.
template <class Predicate>
RunsByKind find_runs(const scene::World& world, Predicate is_wanted) {
    RunsByKind result;
    for (std::size_t kind = 0; kind < scene::kPrimitiveKindCount; ++kind) {
        std::vector<Run>& runs = result[kind];
        const auto& object_ids = world.object_ids[kind];
        for (std::size_t i = 0; i < object_ids.size(); ++i) {
            if (!is_wanted(world.object(object_ids[i]))) continue;
            if (runs.empty() || runs.back().last != i) runs.push_back({i, i});
            ++runs.back().last;
        }
    }
    return result;
}

/// Calls `f` with each kind as a compile-time constant.
template <class F>
void for_each_kind(F f) {
    [&]<std::size_t... kinds>(std::index_sequence<kinds...>) {
        (f.template operator()<static_cast<PrimitiveKind>(kinds)>(), ...);
    }
    (std::make_index_sequence<scene::kPrimitiveKindCount>{});
}

class BruteForce final : public Accel {
 public:
    explicit BruteForce(const scene::World& world)
        : world_(world),
          visible_(find_runs(world, [](const scene::Object& o) { return o.visible; })),
          casting_(find_runs(world,
                             [](const scene::Object& o) { return o.visible && o.casts_shadow; })) {}

    Hit nearest_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        const PreparedRay prepared = prepare(ray);
        Hit best;
        ++counts.rays;
        for_each_kind([&]<PrimitiveKind kind>() {
            for (const Run run : visible_[static_cast<std::size_t>(kind)]) {
                counts.primitive_tests += run.last - run.first;
                nearest_in_run<kind>(run, prepared, interval, best);
            }
        });
        return best;
    }

    bool any_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        const PreparedRay prepared = prepare(ray);
        bool is_hit = false;
        ++counts.rays;
        for_each_kind([&]<PrimitiveKind kind>() {
            for (const Run run : casting_[static_cast<std::size_t>(kind)]) {
                if (is_hit) return;
                const std::size_t tested = tests_until_hit<kind>(run, prepared, interval, is_hit);
                counts.primitive_tests += tested;
            }
        });
        return is_hit;
    }

 private:
    template <PrimitiveKind kind>
    void nearest_in_run(Run run, const PreparedRay& ray, Interval interval, Hit& best) const {
        // Up to and including the best t: at equal t the lesser id wins.
        if (!best.is_none()) interval.hi = next_up(best.t);
        for (std::size_t i = run.first; i < run.last; ++i) {
            const KernelHit found = intersect_kind<kind>(world_, i, ray, interval);
            if (found.is_none()) continue;
            const Hit hit{found.t, found.u, found.v, PrimitiveId(kind, i)};
            if (!is_closer(hit, best)) continue;
            best = hit;
            interval.hi = next_up(best.t);
        }
    }

    template <PrimitiveKind kind>
    std::size_t tests_until_hit(Run run, const PreparedRay& ray, Interval interval,
                                bool& is_hit) const {
        for (std::size_t i = run.first; i < run.last; ++i) {
            if (intersect_kind<kind>(world_, i, ray, interval).is_none()) continue;
            is_hit = true;
            return i - run.first + 1;
        }
        return run.last - run.first;
    }

    const scene::World& world_;
    RunsByKind visible_;
    RunsByKind casting_;
};

}  // namespace

std::unique_ptr<Accel> make_brute_force(const scene::World& world) {
    return std::make_unique<BruteForce>(world);
}

}  // namespace lray::bvh
