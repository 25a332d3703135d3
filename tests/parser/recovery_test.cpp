// What one missing or wrong character costs: a bracket deleted from a good scene is reported, and
// reported about once.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

/// A scene with what the examples may lack: meshes, calls, choices, groups in groups.
constexpr std::string_view kWorkshop = R"(lrs 1.0
render {
  resolution: [320, 240]
  background: #203040
}
camera "front" { position: [0, 2, 8], look_at: [0, 1, 0], fov: 40 }

let r = 0.5
let paint = material {
  diffuse: mix(red, gold, 0.5)
  specular: rgb(0.1, (r + 0.2) / 2, 0.3)
}
let pair = group {
  sphere { radius: r, material: paint }
  sphere { radius: if r > 0.4 then r else 2 * r, translate: [2 * r, 0, 0] }
}

group "workshop" {
  material: paint
  group {
    pair { translate: [0, 1, 0] }
    pair {
      rotate_y: 90
      translate: [0, max(1, r), 0]
    }
  }
  mesh {
    positions: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1]
    ]
    triangles: [[0, 1, 2], [0, 2, 3]]
  }
  box { min: [0, 0, 0], max: [1, 1, 1] }
  transform: [translation([1, 0, 0]), rotation([0, 1, 0], 45)]
}

rectangle {
  size: [8, 8]
  material { diffuse: #808080 }
}
)";

/// Deletes each bracket of a good scene; what it costs is added up.
struct Cost {
    std::size_t deletions = 0;
    std::size_t errors = 0;
};

/// Offsets of the brackets that are code: not in comments or strings.
std::vector<std::size_t> brackets_of(std::string_view text) {
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text[i] == '"') {
            i = text.find('"', i + 1);
        } else if (std::string_view("()[]{}").find(text[i]) != std::string_view::npos) {
            offsets.push_back(i);
        }
    }
    return offsets;
}

template <class Load>
void delete_each_bracket(const std::string& name, const std::string& text, Load load, Cost& cost) {
    for (const std::size_t offset : brackets_of(text)) {
        std::string broken = text;
        broken.erase(offset, 1);
        const Loaded loaded = load(broken);
        const std::size_t count = loaded.diagnostics.error_count();
        ++cost.deletions;
        cost.errors += count;
        const auto line = std::count(text.begin(), text.begin() + static_cast<long>(offset), '\n');
        EXPECT_TRUE(count >= 1 && count <= 3)
            << name << ":" << line + 1 << " without `" << text[offset] << "`:\n"
            << loaded.text();
    }
}

TEST(Recovery, GoodScenesHaveNoErrors) {
    EXPECT_EQ(load_text(kWorkshop).text(), "");
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const Loaded loaded = examples.load_changed(name, examples.text(name));
        EXPECT_FALSE(loaded.has_errors()) << name << "\n" << loaded.text();
    }
}

TEST(Recovery, ADeletedBracketIsReportedAboutOnce) {
    Cost cost;
    delete_each_bracket(
        "workshop", std::string(kWorkshop), [](const std::string& text) { return load_text(text); },
        cost);
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const auto load = [&](const std::string& text) {
            return examples.load_changed(name, text);
        };
        delete_each_bracket(name, examples.text(name), load, cost);
    }
    ASSERT_GT(cost.deletions, 100u);
    const double average = static_cast<double>(cost.errors) / static_cast<double>(cost.deletions);
    RecordProperty("average", fmt::format("{:.3f}", average));
    EXPECT_LE(average, 1.2) << cost.errors << " errors of " << cost.deletions << " deletions";
}

}  // namespace
}  // namespace lray::test
