// What the viewer is given, and what it asks of the program around it: so it knows neither the
// language nor the command line.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/bounds.h"
#include "gui/slider_value.h"
#include "image/image.h"
#include "image/tone_map.h"
#include "render/prepared_scene.h"
#include "render/view.h"
#include "scene/camera.h"

namespace lray::gui {

/// What came of loading the scene.
struct LoadedScene {
    std::unique_ptr<const render::PreparedScene> prepared{};  // none: there were errors
    render::View view{};               // as the command line and the scene ask for it
    Bounds bounds{};                   // of all that is finite
    std::string hierarchy{};           // in words: "boxes, 1234 nodes"
    std::vector<Slider> sliders{};     // of its params
    std::string messages{};            // errors in words, line by line; else what is said of it
    std::vector<std::string> files{};  // that it was read from, or looked for in vain
};

/// The value of a param: its name, and the value as text of the language.
using ParamText = std::pair<std::string, std::string>;

/// Stored views by their numbers, 1 to 9.
using StoredViews = std::map<int, scene::Camera>;

/// What a step of the program came to, in a sentence.
struct Outcome {
    bool is_done = true;
    std::string sentence{};
};

struct Program {
    std::string title{};         // of the scene
    bool can_load_again = true;  // false of a scene from stdin

    // Called by other threads, one call at a time:
    std::function<LoadedScene(std::span<const ParamText>)> load{};
    std::function<Outcome(image::Image light, const image::DisplaySettings&)> save{};

    // Called by the thread of the window:
    std::function<std::string(const scene::Camera&)> camera_text{};
    std::function<StoredViews()> read_views{};
    std::function<Outcome(const StoredViews&)> write_views{};
    std::function<void(std::string_view)> print{};  // a line of what was asked for
    std::function<bool()> is_interrupted{};

    /// Says why there is no window any more, and ends the program: called where nothing can be
    /// returned to.
    std::function<void(std::string_view)> end_without_window{};
};

}  // namespace lray::gui
