// Reads OBJ files for the tests, and tells what was told of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "scene/formats/obj_reader.h"

namespace lray::scene {

/// An OBJ file that was loaded by a scene.
struct Reading {
    explicit Reading(std::string_view obj) {
        const SourceId scene = sources.add("scene.lrs", Text("mesh { file: \"a.obj\" }"));
        loaded_at = Span::make(scene, 13, 20);
        file = sources.add("a.obj", Text(obj));
        mesh = read_obj(sources, file, loaded_at, diagnostics);
    }

    /// "line:column code `spanned text` message", one line for each.
    std::string errors() const {
        std::string all;
        for (const Diagnostic* diagnostic : diagnostics.sorted()) {
            const Position position = sources.position(diagnostic->span);
            all += fmt::format("{}:{} {} `{}` {}\n", position.line, position.column,
                               name(diagnostic->code), sources.text(diagnostic->span),
                               diagnostic->message);
        }
        return all;
    }

    static std::string_view name(Code code) {
        if (code == Code::E0003) return "E0003";
        if (code == Code::E0701) return "E0701";
        if (code == Code::E0702) return "E0702";
        if (code == Code::E0704) return "E0704";
        if (code == Code::E0705) return "E0705";
        return "?";
    }

    Sources sources;
    Diagnostics diagnostics;
    Span loaded_at{};
    SourceId file = kNoSource;
    std::optional<Mesh> mesh;
};

/// Returns the mesh of a correct file.
inline Mesh read(std::string_view obj) {
    Reading reading(obj);
    EXPECT_TRUE(reading.mesh.has_value()) << reading.errors();
    EXPECT_EQ(reading.diagnostics.error_count(), 0u);
    EXPECT_EQ(reading.diagnostics.warning_count(), 0u);
    return reading.mesh.value_or(Mesh{});
}

/// Returns the errors of a wrong file, each with its label where the file was loaded.
inline std::string errors(std::string_view obj) {
    const Reading reading(obj);
    EXPECT_FALSE(reading.mesh.has_value());
    EXPECT_GT(reading.diagnostics.error_count(), 0u);
    for (const Diagnostic* diagnostic : reading.diagnostics.sorted()) {
        EXPECT_EQ(diagnostic->span.source, reading.file);
        if (diagnostic->labels.size() != 1) {
            ADD_FAILURE() << "no label";
            continue;
        }
        EXPECT_EQ(diagnostic->labels[0].span, reading.loaded_at);
        EXPECT_EQ(diagnostic->labels[0].message, "loaded here");
    }
    return reading.errors();
}

inline constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";  // lines 1 to 3

inline std::string on_line_4(std::string_view text) {
    return fmt::format("{}{}\nf 1 2 3\n", kTriangle, text);
}

}  // namespace lray::scene
