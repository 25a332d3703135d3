// Brings the files that a scene names into the load: text of includes, meshes, pictures. Each mesh
// and picture is read once per run.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "image/image.h"
#include "parser/load.h"
#include "scene/formats/mtl_reader.h"
#include "scene/formats/read_mesh.h"
#include "scene/scene.h"

namespace lray::parser {

/// Turns names in a scene into sources, meshes and pictures, once per run for each of the latter.
class FileLoader {
 public:
    /// `importer`: the program for meshes that are neither OBJ nor PLY; empty: none.
    FileLoader(FileAccess& files, Sources& sources, const LoadLimits& limits,
               std::string_view importer, Diagnostics& diagnostics)
        : files_(files),
          sources_(sources),
          limits_(limits),
          import_{std::string(importer), limits.import_seconds, limits.import_bytes},
          diagnostics_(diagnostics) {}

    /// Reads the main scene. Errors: empty, E06.. reported without a place.
    std::optional<SourceId> main_scene(std::string_view path);

    /// Reads a file named at `span` in the source `from`, for inclusion.
    /// Errors: empty, reported at `span`: E0515 too many files, E0601 and its like.
    std::optional<SourceId> scene(std::string_view path, SourceId from, Span span);

    /// What tells the file of a source from others, however it was named.
    const std::string& identity(SourceId source) const { return identities_.at(source); }

    /// True if both sources are the same file, however each was named.
    bool is_same_file(SourceId a, SourceId b) const;

    /// Returns the mesh of a file named at `span` in the source `from`; with normals of its own if
    /// `smooth_degrees` is given. What one file gives counts as a file for each other smoothness.
    /// Errors: empty, reported at `span` or in the mesh file; the same file again is silent,
    /// however it is named.
    std::optional<scene::MeshId> mesh(std::string_view path, SourceId from, Span span,
                                      std::optional<double> smooth_degrees, scene::Scene& scene);

    /// The source that a mesh was read from. Shape: mesh() returned it.
    SourceId source_of(scene::MeshId mesh_id) const { return mesh_sources_.at(mesh_id.value); }

    /// Reads a file that the mesh file `from` names, told at `span`. It counts as a mesh file.
    /// Errors: empty; W1701 when it is not there or may not be read, E0515 and E0516 limits.
    std::optional<SourceId> companion(std::string_view path, SourceId from, Span span);

    /// Returns the picture of a file named at `span` in a companion file, as picture() does.
    /// Errors: empty; W1701, once, when it is not there, may not be read or is of another format.
    std::optional<scene::PictureId> companion_picture(std::string_view path, SourceId from,
                                                      Span span, scene::Scene& scene);

    /// The materials of a mesh file, by Mesh::material_names; empty until somebody fills them in.
    std::vector<scene::MaterialId>& materials_of(SourceId mesh_file) {
        return materials_[mesh_file];
    }

    /// Returns the materials that a companion defines, of those wanted, as read_mtl().
    std::optional<std::vector<scene::MtlMaterial>> definitions(
        SourceId mtl, Span span, const std::unordered_set<std::string>& wanted) {
        return scene::read_mtl(sources_, mtl, span, wanted, diagnostics_);
    }

    /// Forgets the text of a companion file of which nothing will be shown.
    void release_text(SourceId file) { sources_.release_text(file); }

    /// Decodes a picture file of heights named at `span` in the source `from`. It counts as a
    /// mesh file.
    /// Errors: empty, reported at `span`: E0601 and its like, E0703 not a picture, or too large.
    std::optional<image::Image> heights(std::string_view path, SourceId from, Span span);

    /// Returns the picture of a file named at `span` in the source `from`.
    /// Errors: empty, reported at `span`: E0516 beyond the limits, which the header tells, E0601
    /// and its like, E0703 what is wrong in the file, E0705 another format; W1703 for values that
    /// are no light, which are mended. The same file again is silent.
    std::optional<scene::PictureId> picture(std::string_view path, SourceId from, Span span,
                                            scene::Scene& scene);

 private:
    /// Whether a file that cannot be had is an error, or a warning.
    enum class Need : std::uint8_t { required, optional };

    std::optional<scene::PictureId> read_picture(std::string_view path, SourceId from, Span span,
                                                 Need need, scene::Scene& scene);
    void warn_of_mended(image::Image& light, std::string_view path, Span span);

    /// Of all files of a kind together: a small one may be named ten thousand times.
    struct SizeLimit {
        std::uint64_t bytes = 0;
        std::string_view flag{};
        std::uint64_t left = bytes;
        bool is_exceeded = false;
    };

    /// A file that is named at `span`, and part of what stands at `included_from`, if anywhere.
    struct Request {
        std::string_view path{};
        Span span{};
        Span included_from{};
        SizeLimit& limit;
        Need need = Need::required;
    };

    /// Where a file is and what tells it from others; `id` is empty for one that was known.
    struct Found {
        std::string identity{};
        std::optional<SourceId> id{};
    };

    /// A mesh file that was read, and the meshes that were made of it.
    struct LoadedMesh {
        std::uint64_t size = 0;  // of the file
        std::map<std::optional<double>, scene::MeshId> by_smoothness{};
        // Those of the file, where the first mesh was given others.
        std::vector<Vec3> normals{};
        std::vector<scene::IndexTriple> normal_indices{};
    };

    std::string path_from_main(SourceId file) const;
    std::optional<Found> read(const Request& request, SourceId from,
                              const std::set<std::string>& known = {});
    std::optional<Found> add(ReadResult result, const Request& request,
                             const std::set<std::string>& known = {});
    std::optional<LoadedMesh> read_mesh(scene::MeshFormat format, SourceId file, Span span,
                                        std::optional<double> smooth_degrees, scene::Scene& scene);
    std::optional<scene::MeshId> smooth_again(LoadedMesh& loaded, const Request& request,
                                              std::optional<double> smooth_degrees,
                                              scene::Scene& scene);
    void report_too_large(const Request& request);
    void warn_missing(const ReadResult& result, const Request& request);
    void report(const ReadResult& result, const Request& request);
    void report_not_found(const ReadResult& result, const Request& request);

    FileAccess& files_;
    Sources& sources_;
    LoadLimits limits_;
    scene::ImportSettings import_;
    SizeLimit scene_limit_{limits_.scene_bytes, "--max-scene-bytes"};
    SizeLimit mesh_limit_{limits_.mesh_bytes, "--max-mesh-bytes"};
    SizeLimit texture_limit_{limits_.texture_bytes, "--max-texture-bytes"};
    std::uint64_t texture_pixels_left_ = limits_.texture_pixels;
    Diagnostics& diagnostics_;
    std::string main_directory_{};
    std::map<SourceId, std::string> directories_;
    std::map<SourceId, std::string> identities_;  // empty: of what is no file
    // By directory and name; empty: not a mesh, which was told.
    std::map<std::pair<std::string, std::string>, std::optional<std::string>> mesh_identities_;
    std::map<std::pair<std::string, std::string>, std::optional<scene::PictureId>> pictures_;
    std::set<std::pair<std::string, std::string>> companion_pictures_;  // that were asked for
    std::map<std::string, std::optional<LoadedMesh>> meshes_by_identity_;
    std::map<std::uint32_t, SourceId> mesh_sources_;
    std::map<SourceId, std::vector<scene::MaterialId>> materials_;
    std::set<std::string> mesh_files_;  // their identities
};

}  // namespace lray::parser
