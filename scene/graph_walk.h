// Walks the graph and places what it leads to.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "scene/flatten_plan.h"
#include "scene/placer.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// Errors of one flattening after which it gives up: a scene that is broken in a million places
/// has been told so.
inline constexpr std::size_t kMaxFlattenErrors = 100;

/// Walks every path from a node to a shape or to what is shared, in the order of the graph. The
/// stack is its own: how deep groups nest is up to the scene.
class GraphWalk {
 public:
    /// `prototypes`: all that are placed on the way. `lights`: where to put the lights, of what is
    /// shared too; null: they are not asked for.
    GraphWalk(const Scene& scene, const FlattenPlan& plan, std::span<const Prototype> prototypes,
              Placer& placer, std::vector<WorldLight>* lights, Diagnostics& diagnostics)
        : scene_(scene),
          plan_(plan),
          prototypes_(prototypes),
          placer_(placer),
          lights_(lights),
          diagnostics_(diagnostics) {}

    /// Places a node of a world.
    void place(NodeId id);

    /// Places what a node holds, under `placement` instead of its own settings.
    void place_content(NodeId id, const Placement& placement);

    /// How many errors were reported.
    std::size_t error_count() const { return refused_count_ + placer_.refused_count(); }

 private:
    /// In what is shared only the lights are still to be placed.
    enum class Wanted : std::uint8_t { all, lights };

    struct Step {
        NodeId id{};
        Wanted wanted = Wanted::all;
        std::size_t next_child = 0;
        Placement placement{};
    };

    void run();
    void enter(NodeId id, Placement placement, Wanted wanted);
    bool is_wanted(const Node& node, Wanted wanted) const;
    bool settle(const Node& node, Placement& placement);
    void place_light(NodeId id, const Node& node, const Placement& placement);
    Diagnostic& refuse(Code code, const Node& node, std::string message);

    const Scene& scene_;
    const FlattenPlan& plan_;
    std::span<const Prototype> prototypes_;
    Placer& placer_;
    std::vector<WorldLight>* lights_;
    Diagnostics& diagnostics_;
    std::vector<Step> stack_{};
    Span environment_{};  // the first one
    std::size_t refused_count_ = 0;
};

}  // namespace lray::scene
