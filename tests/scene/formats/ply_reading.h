// Makes and reads PLY files for the tests, and tells what was told of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "scene/formats/ply_reader.h"
#include "tests/scene/formats/obj_reading.h"

namespace lray::scene::ply {

/// A PLY file that was loaded by a scene.
struct PlyReading {
    explicit PlyReading(std::string_view ply) {
        const SourceId scene = sources.add("scene.lrs", Text("mesh { file: \"a.ply\" }"));
        loaded_at = Span::make(scene, 13, 20);
        file = sources.add("a.ply", Text(ply));
        mesh = read_ply(sources, file, loaded_at, diagnostics);
    }

    Sources sources;
    Diagnostics diagnostics;
    Span loaded_at{};
    SourceId file = kNoSource;
    std::optional<Mesh> mesh;
};

/// Returns the one error of a wrong file: "line:column code `spanned text` message" where it has a
/// place in the file, else "code message" where it is named.
inline std::string error_of(std::string_view ply) {
    const PlyReading reading(ply);
    EXPECT_FALSE(reading.mesh.has_value());
    const auto all = reading.diagnostics.sorted();
    if (all.size() != 1 || reading.diagnostics.error_count() != 1) return "not one error";
    const Diagnostic& error = *all[0];
    const std::string_view code = Reading::name(error.code);
    if (error.span == reading.loaded_at) return fmt::format("{} {}", code, error.message);
    EXPECT_EQ(error.span.source, reading.file);
    const bool has_label = error.labels.size() == 1 && error.labels[0].span == reading.loaded_at;
    EXPECT_TRUE(has_label) << "no label where the file is named";
    const Position position = reading.sources.position(error.span);
    return fmt::format("{}:{} {} `{}` {}", position.line, position.column, code,
                       reading.sources.text(error.span), error.message);
}

/// Returns the mesh of a correct file.
inline Mesh mesh_of(std::string_view ply) {
    PlyReading reading(ply);
    for (const Diagnostic* diagnostic : reading.diagnostics.sorted()) {
        ADD_FAILURE() << diagnostic->message;
    }
    EXPECT_TRUE(reading.mesh.has_value());
    return reading.mesh.value_or(Mesh{});
}

/// Bytes of a body in binary.
class Bytes {
 public:
    explicit Bytes(bool is_big_endian) : is_big_endian_(is_big_endian) {}

    template <class T>
    Bytes& add(T value) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        if (is_big_endian_) std::reverse(bytes, bytes + sizeof(T));
        text_.append(bytes, sizeof(T));
        return *this;
    }

    template <class T, class... More>
    Bytes& add_all(T value, More... more) {
        add(value);
        (add(static_cast<T>(more)), ...);
        return *this;
    }

    const std::string& text() const { return text_; }

 private:
    bool is_big_endian_;
    std::string text_;
};

/// Lines of a header with `ply` and `format` before them and `end_header` behind.
inline std::string header(std::string_view coding, std::string_view lines) {
    return fmt::format("ply\nformat {} 1.0\n{}end_header\n", coding, lines);
}

inline constexpr std::string_view kXyz = "property float x\nproperty float y\nproperty float z\n";
inline constexpr std::string_view kTriangleRows = "0 0 0\n1 0 0\n0 1 0\n";

/// Text with three vertices, of which the header ends in line 9 and the only face is in line 13.
inline std::string ascii_face(std::string_view row) {
    return header("ascii", fmt::format("element vertex 3\n{}element face 1\n"
                                       "property list uchar int vertex_indices\n",
                                       kXyz)) +
           fmt::format("{}{}\n", kTriangleRows, row);
}

}  // namespace lray::scene::ply
