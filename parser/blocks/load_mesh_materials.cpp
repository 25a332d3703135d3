#include "parser/blocks/load_mesh_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "parser/blocks/build_texture.h"
#include "scene/formats/mtl_material.h"
#include "scene/formats/mtl_reader.h"
#include "scene/formats/obj_assemble.h"

namespace lray::parser {

namespace {

/// Each takes much more memory than the few bytes that name it.
constexpr std::size_t kMaxMaterials = std::size_t{1} << 16;

/// What a picture is of: colours as a screen shows them, or numbers.
enum class Coding : bool { numbers, colors };

class MaterialLoader {
 public:
    MaterialLoader(SourceId mtl, FileLoader& files, scene::Scene& scene)
        : mtl_(mtl), files_(files), scene_(scene) {}

    scene::MaterialId add(const scene::MtlMaterial& material) {
        const scene::MtlTextures ids{
            texture(material.diffuse_map, Coding::colors),
            texture(material.specular_map, Coding::colors),
            texture(material.emission_map, Coding::colors),
            texture(material.opacity_map, Coding::numbers),
            texture(material.normal_map, Coding::numbers),
            texture(material.bump_map, Coding::numbers),
        };
        scene_.materials.push_back(scene::material_of(material, ids, scene_.textures));
        return scene::MaterialId(scene_.materials.size() - 1);
    }

 private:
    scene::TextureId texture(const std::optional<scene::MtlMap>& map, Coding coding) {
        if (!map) return {};
        const auto picture_id = files_.companion_picture(map->file, mtl_, map->span, scene_);
        if (!picture_id) return {};
        scene::ImageTexture image;
        image.picture_id = *picture_id;
        image.wrap = map->is_clamped ? scene::ImageWrap::clamp : scene::ImageWrap::repeat;
        image.is_srgb = coding == Coding::colors;
        scene::Texture texture{image, scene::TextureSpace::uv};
        texture.space_from_texture = scene::uv_from_picture(*map);
        const std::optional<Transform> inverse = texture.space_from_texture.inverse();
        LRAY_ASSERT(inverse);  // the reader bounds the scale
        texture.texture_from_space = *inverse;
        return add_texture(std::move(texture), scene_);
    }

    SourceId mtl_ = kNoSource;
    FileLoader& files_;
    scene::Scene& scene_;
};

/// Names the first few: "`a`, `b` and 7 more".
std::string list_of(const std::vector<std::string_view>& names) {
    constexpr std::size_t kMaxNamed = 3;
    constexpr std::size_t kMaxLength = 48;
    std::string list;
    const std::size_t named = std::min(names.size(), kMaxNamed);
    for (std::size_t i = 0; i < named; ++i) {
        const bool is_last = i + 1 == names.size();
        if (i > 0) list += is_last ? " and " : ", ";
        std::string_view name = names[i];
        const bool is_long = name.size() > kMaxLength;
        if (is_long) {
            std::size_t length = kMaxLength;
            // Not in the middle of a UTF-8 sequence.
            while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xc0u) == 0x80u) {
                --length;
            }
            name = name.substr(0, length);
        }
        list += fmt::format("`{}{}`", name, is_long ? "..." : "");
    }
    if (names.size() > named) list += fmt::format(" and {} more", names.size() - named);
    return list;
}

void warn_undefined(const scene::Mesh& mesh, const std::vector<scene::MaterialId>& found, Span span,
                    Diagnostics& diagnostics) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i].is_none()) names.push_back(mesh.material_names[i]);
    }
    if (names.empty()) return;
    diagnostics.warning(Code::W1701, span,
                        fmt::format("the material{} {} of `{}` {} defined in no file that it names",
                                    names.size() == 1 ? "" : "s", list_of(names), mesh.file,
                                    names.size() == 1 ? "is" : "are"));
}

/// Puts the materials of a mesh that its files define where their names are.
bool read_materials(const scene::Mesh& mesh, SourceId source, Span span,
                    std::vector<scene::MaterialId>& found, FileLoader& files, scene::Scene& scene,
                    Diagnostics& diagnostics) {
    std::unordered_map<std::string, std::size_t> numbers;
    std::unordered_set<std::string> wanted;
    const std::size_t count = std::min(mesh.material_names.size(), kMaxMaterials);
    for (std::size_t i = 0; i < count; ++i) {
        numbers.emplace(mesh.material_names[i], i);
        wanted.insert(mesh.material_names[i]);
    }
    const std::uint64_t errors_before = diagnostics.error_count();
    bool is_file_missing = false;
    std::size_t file_count = mesh.material_files.size();
    if (file_count > scene::obj::kMaxMaterialFiles) {
        file_count = scene::obj::kMaxMaterialFiles;
        diagnostics.warning(Code::W1701, span,
                            fmt::format("`{}` names more than {} files with materials; the others "
                                        "are not read",
                                        mesh.file, file_count));
    }
    for (std::size_t i = 0; i < file_count && !wanted.empty(); ++i) {
        const auto mtl = files.companion(mesh.material_files[i], source, span);
        is_file_missing = is_file_missing || !mtl;
        if (!mtl) continue;
        const std::size_t told_before = diagnostics.error_count() + diagnostics.warning_count();
        const auto materials = files.definitions(*mtl, span, wanted);
        if (!materials) return false;
        MaterialLoader loader(*mtl, files, scene);
        for (const scene::MtlMaterial& material : *materials) {
            found[numbers.at(material.name)] = loader.add(material);
            wanted.erase(material.name);
        }
        if (diagnostics.error_count() + diagnostics.warning_count() == told_before) {
            files.release_text(*mtl);
        }
    }
    // It has been told, and may be the one that defines them.
    if (!is_file_missing) warn_undefined(mesh, found, span, diagnostics);
    return diagnostics.error_count() == errors_before;
}

}  // namespace

bool load_mesh_materials(scene::MeshId mesh_id, Span span, FileLoader& files, scene::Scene& scene,
                         Diagnostics& diagnostics) {
    scene::Mesh& mesh = scene.meshes[mesh_id.index()];
    if (mesh.material_names.empty() || !mesh.materials.empty()) return true;
    const SourceId source = files.source_of(mesh_id);
    std::vector<scene::MaterialId>& known = files.materials_of(source);
    if (known.empty()) {
        known.resize(mesh.material_names.size());
        if (!read_materials(mesh, source, span, known, files, scene, diagnostics)) return false;
    }
    mesh.materials = known;
    return true;
}

}  // namespace lray::parser
