#include "tests/parser/evaluate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/parser/loaded.h"

namespace lray::test {

namespace {

Loaded load_right(const std::string& scene) {
    Loaded loaded = load_text(scene);
    EXPECT_FALSE(loaded.has_errors()) << scene << "\n" << loaded.text();
    return loaded;
}

}  // namespace

double number_of(std::string_view expression, std::string_view before) {
    return vec3_of(fmt::format("[{}, 0, 0]", expression), before).x;
}

DVec3 vec3_of(std::string_view expression, std::string_view before) {
    const Loaded loaded =
        load_right(fmt::format("{}\nsphere {{ center: {} }}", before, expression));
    if (!loaded.scene) return DVec3{std::numeric_limits<double>::quiet_NaN()};
    return loaded.scene->spheres.back().center;
}

bool is_true(std::string_view condition, std::string_view before) {
    return number_of(fmt::format("if {} then 1 else 0", condition), before) == 1.0;
}

std::string string_of(std::string_view expression, std::string_view before) {
    const Loaded loaded = load_right(fmt::format("{}\ninfo {{ title: {} }}", before, expression));
    return loaded.scene ? loaded.scene->info.at(0).second : "";
}

Color color_of(std::string_view expression, std::string_view before) {
    const Loaded loaded =
        load_right(fmt::format("{}\nlet m = material {{ diffuse: {} }}", before, expression));
    return loaded.scene ? loaded.scene->materials.back().diffuse.constant : Color{-1.0f};
}

std::string codes_of(std::string_view scene) {
    const Loaded loaded = load_text(scene);
    std::string codes;
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        if (diagnostic->code == Code::W1501 || diagnostic->code == Code::W1503) continue;
        codes += fmt::format("{}{}", codes.empty() ? "" : " ", code_info(diagnostic->code).id);
    }
    return codes;
}

}  // namespace lray::test
