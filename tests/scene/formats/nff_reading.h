// Reads NFF files for the tests, and tells what was told of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic_codes.h"
#include "scene/formats/nff_reader.h"

namespace lray::scene {

struct NffReading {
    explicit NffReading(std::string_view nff, const NffLimits& limits = {}) {
        file = sources.add("a.nff", Text(nff));
        scene = read_nff(sources, file, limits, diagnostics);
    }

    /// "line:column code `spanned text` message", one line for each.
    std::string errors() const {
        std::string all;
        for (const Diagnostic* diagnostic : diagnostics.sorted()) {
            const Position position = sources.position(diagnostic->span);
            all += fmt::format("{}:{} {} `{}` {}\n", position.line, position.column,
                               code_info(diagnostic->code).id, sources.text(diagnostic->span),
                               diagnostic->message);
        }
        return all;
    }

    Sources sources;
    Diagnostics diagnostics;
    SourceId file = kNoSource;
    std::optional<NffScene> scene;
};

/// Returns what a correct file says.
inline NffScene read_nff_text(std::string_view nff) {
    NffReading reading(nff);
    EXPECT_TRUE(reading.scene.has_value()) << reading.errors();
    EXPECT_EQ(reading.errors(), "");
    return reading.scene.value_or(NffScene{});
}

/// Returns the errors of a wrong file.
inline std::string nff_errors(std::string_view nff, const NffLimits& limits = {}) {
    const NffReading reading(nff, limits);
    EXPECT_FALSE(reading.scene.has_value());
    return reading.errors();
}

inline constexpr std::string_view kFill = "f 1 1 1 1 0 1 0 1\n";  // line 1

inline std::string on_line_2(std::string_view text) {
    return fmt::format("{}{}\n", kFill, text);
}

}  // namespace lray::scene
