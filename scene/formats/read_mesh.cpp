#include "scene/formats/read_mesh.h"

#include <algorithm>
#include <array>

#include "base/assert.h"
#include "base/did_you_mean.h"
#include "scene/formats/obj_reader.h"
#include "scene/formats/ply_reader.h"

namespace lray::scene {

namespace {

bool ends_with(std::string_view path, std::string_view ending) {
    if (path.size() < ending.size()) return false;
    return edit_distance(path.substr(path.size() - ending.size()), ending, 0) == 0;
}

}  // namespace

std::optional<MeshFormat> mesh_format_of(std::string_view path) {
    constexpr std::array<std::string_view, 6> kOthers = {".abc", ".blend", ".mtl",
                                                         ".usd", ".usda",  ".x3d"};
    if (ends_with(path, ".ply")) return MeshFormat::ply;
    if (!imported_ending(path).empty()) return MeshFormat::imported;
    const bool is_other = std::any_of(kOthers.begin(), kOthers.end(), [&](std::string_view known) {
        return ends_with(path, known);
    });
    if (is_other) return std::nullopt;
    return MeshFormat::obj;
}

std::optional<Mesh> read_mesh(MeshFormat format, const Sources& sources, SourceId file,
                              Span loaded_at, const ImportSettings& import,
                              Diagnostics& diagnostics) {
    switch (format) {
        case MeshFormat::obj:
            return read_obj(sources, file, loaded_at, diagnostics);
        case MeshFormat::ply:
            return read_ply(sources, file, loaded_at, diagnostics);
        case MeshFormat::imported:
            return import_mesh(sources, file, loaded_at, import, diagnostics);
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::scene
