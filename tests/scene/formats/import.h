// A mesh that was read by a program of its own.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "scene/formats/read_mesh.h"
#include "tests/scene/formats/obj_reading.h"

namespace lray::scene {

/// A file of that name that was read by a program.
struct Import {
    Import(std::string_view name, std::string_view bytes, ImportSettings settings) {
        const SourceId scene = sources.add("scene.lrs", Text("mesh { file: \"a\" }"));
        loaded_at = Span::make(scene, 13, 16);
        const SourceId file = sources.add(std::string(name), Text(bytes));
        mesh = read_mesh(MeshFormat::imported, sources, file, loaded_at, settings, diagnostics);
    }

    /// The one error, at the name of the file: "code message", and "; help" if it has one.
    std::string error() const {
        const auto all = diagnostics.sorted();
        if (mesh || all.size() != 1 || all[0]->severity != Severity::error) return "not one error";
        if (all[0]->span != loaded_at) return "elsewhere";
        const std::string_view code =
            all[0]->code == Code::E0516 ? "E0516" : Reading::name(all[0]->code);
        std::string text = fmt::format("{} {}", code, all[0]->message);
        if (!all[0]->helps.empty()) text += "; " + all[0]->helps[0];
        return text;
    }

    Sources sources;
    Diagnostics diagnostics;
    Span loaded_at{};
    std::optional<Mesh> mesh;
};

}  // namespace lray::scene
