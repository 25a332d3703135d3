#include "bvh/brute_force.h"

#include <array>
#include <utility>
#include <vector>

#include "bvh/instance_ray.h"
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
RunsByKind find_runs(const scene::Geometry& geometry, Predicate is_wanted) {
    RunsByKind result;
    for (std::size_t kind = 0; kind < scene::kPrimitiveKindCount; ++kind) {
        std::vector<Run>& runs = result[kind];
        const auto& object_ids = geometry.object_ids[kind];
        for (std::size_t i = 0; i < object_ids.size(); ++i) {
            if (!is_wanted(geometry.object(object_ids[i]))) continue;
            if (runs.empty() || runs.back().last != i) runs.push_back({i, i});
            ++runs.back().last;
        }
    }
    return result;
}

/// Calls `f` with each kind that has a surface as a compile-time constant.
template <class F>
void for_each_kind(F f) {
    [&]<std::size_t... kinds>(std::index_sequence<kinds...>) {
        (f.template operator()<static_cast<PrimitiveKind>(kinds)>(), ...);
    }
    (std::make_index_sequence<scene::kSurfaceKindCount>{});
}

/// A geometry and which of it counts.
struct Part {
    const scene::Geometry* geometry = nullptr;
    RunsByKind visible{};
    RunsByKind casting{};

    explicit Part(const scene::Geometry& source)
        : geometry(&source),
          visible(find_runs(source, [](const scene::Object& o) { return o.visible; })),
          casting(find_runs(source,
                            [](const scene::Object& o) { return o.visible && o.casts_shadow; })) {}
};

const std::vector<Run>& runs_of(const RunsByKind& runs, PrimitiveKind kind) {
    return runs[static_cast<std::size_t>(kind)];
}

class BruteForce final : public Accel {
 public:
    explicit BruteForce(const scene::World& world) : world_(world) {
        for (const scene::Geometry& prototype : world.prototypes)
            prototypes_.emplace_back(prototype);
    }

    Hit nearest_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        Hit best;
        ++counts.rays;
        if (is_traceable(ray)) nearest(world_, 0, prepare(ray), interval, best, counts);
        return best;
    }

    bool any_hit(const Ray& ray, Interval interval, TraceCounts& counts) const override {
        ++counts.rays;
        return is_traceable(ray) && any(world_, prepare(ray), interval, counts);
    }

    AccelStats stats() const override {
        AccelStats stats;
        stats.bytes = sizeof *this + prototypes_.capacity() * sizeof(Part);
        add_runs(world_, stats);
        for (const Part& part : prototypes_) add_runs(part, stats);
        return stats;
    }

 private:
    static void add_runs(const Part& part, AccelStats& stats) {
        for (std::size_t kind = 0; kind < scene::kPrimitiveKindCount; ++kind) {
            stats.bytes +=
                (part.visible[kind].capacity() + part.casting[kind].capacity()) * sizeof(Run);
            for (const Run run : part.visible[kind]) stats.references += run.last - run.first;
        }
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
    void nearest(const Part& part, scene::PlaceOffset place, const PreparedRay& ray,
                 Interval interval, Hit& best, TraceCounts& counts) const {
        for_each_kind([&]<PrimitiveKind kind>() {
            for (const Run run : runs_of(part.visible, kind)) {
                counts.primitive_tests += run.last - run.first;
                for (std::size_t i = run.first; i < run.last; ++i) {
                    const KernelHit found =
                        intersect_kind<kind>(*part.geometry, i, ray, up_to(best, interval));
                    if (found.is_none()) continue;
                    const Hit hit{found.t, found.u,     found.v, PrimitiveId(kind, i),
                                  place,   found.normal};
                    if (is_closer(hit, best)) best = hit;
                }
            }
        });
        for (const Run run : runs_of(part.visible, PrimitiveKind::instance)) {
            for (std::size_t i = run.first; i < run.last; ++i) {
                const scene::WorldInstance& instance = part.geometry->instances[i];
                const Interval inside = interval_in(instance, ray, up_to(best, interval), counts);
                if (inside.is_empty()) continue;
                nearest(prototypes_[instance.prototype], place + instance.first_place,
                        ray_in(instance, ray), inside, best, counts);
            }
        }
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as instances nest
    bool any(const Part& part, const PreparedRay& ray, Interval interval,
             TraceCounts& counts) const {
        bool is_hit = false;
        for_each_kind([&]<PrimitiveKind kind>() {
            for (const Run run : runs_of(part.casting, kind)) {
                for (std::size_t i = run.first; i < run.last && !is_hit; ++i) {
                    ++counts.primitive_tests;
                    is_hit = !intersect_kind<kind>(*part.geometry, i, ray, interval).is_none();
                }
            }
        });
        for (const Run run : runs_of(part.casting, PrimitiveKind::instance)) {
            for (std::size_t i = run.first; i < run.last && !is_hit; ++i) {
                const scene::WorldInstance& instance = part.geometry->instances[i];
                const Interval inside = interval_in(instance, ray, interval, counts);
                is_hit = !inside.is_empty() && any(prototypes_[instance.prototype],
                                                   ray_in(instance, ray), inside, counts);
            }
        }
        return is_hit;
    }

    Part world_;
    std::vector<Part> prototypes_;
};

}  // namespace

std::unique_ptr<Accel> make_brute_force(const scene::World& world) {
    return std::make_unique<BruteForce>(world);
}

}  // namespace lray::bvh
