#include "parser/file_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <utility>

#include "base/angle.h"
#include "base/did_you_mean.h"
#include "base/path.h"
#include "image/read.h"
#include "scene/formats/read_mesh.h"
#include "scene/smooth_normals.h"

namespace lray::parser {

namespace {

/// The ending of a file name when it is one of these, in any letter case; empty otherwise.
std::string_view ending_among(std::string_view path, std::span<const std::string_view> endings) {
    for (const std::string_view known : endings) {
        if (path.size() < known.size()) continue;
        const std::string_view ending = path.substr(path.size() - known.size());
        if (edit_distance(ending, known, 0) == 0) return ending;
    }
    return {};
}

/// The ending of a file name when it is that of a picture format that is not read; empty otherwise.
std::string_view other_picture_format(std::string_view path) {
    constexpr std::array<std::string_view, 12> kOthers = {".avif", ".bmp", ".dds",  ".gif",
                                                          ".heic", ".jp2", ".jxl",  ".pbm",
                                                          ".tga",  ".tif", ".tiff", ".webp"};
    return ending_among(path, kOthers);
}

}  // namespace

std::optional<SourceId> FileLoader::main_scene(std::string_view path) {
    const auto most = std::min<std::uint64_t>(scene_limit_.bytes, Sources::kMaxTextSize);
    const std::optional<Found> found =
        add(files_.read_main(path, most), {path, Span{}, Span{}, scene_limit_});
    if (!found) return std::nullopt;
    main_directory_ = absolute_path(directories_[*found->id]);
    return found->id;
}

std::string FileLoader::path_from_main(SourceId file) const {
    const std::string& path = sources_[file].path;
    if (path.starts_with("std:")) return path;
    return std::filesystem::path(absolute_path(path)).lexically_relative(main_directory_).string();
}

std::optional<SourceId> FileLoader::scene(std::string_view path, SourceId from, Span span) {
    const std::optional<Found> found = read({path, span, span, scene_limit_}, from);
    return found ? found->id : std::nullopt;
}

bool FileLoader::is_same_file(SourceId a, SourceId b) const {
    const std::string& identity = identities_.at(a);
    return a == b || (!identity.empty() && identity == identities_.at(b));
}

std::optional<FileLoader::Found> FileLoader::read(const Request& request, SourceId from,
                                                  const std::set<std::string>& known) {
    if (sources_.count() >= limits_.files || sources_.is_full()) {
        diagnostics_
            .error(Code::E0515, request.span, fmt::format("more than {} files", limits_.files))
            .with_help("raise the limit with `--max-files N`");
        return std::nullopt;
    }
    if (request.limit.is_exceeded) return std::nullopt;  // said once
    if (request.path.empty()) {
        diagnostics_.error(Code::E0601, request.span, "the file name is empty");
        return std::nullopt;
    }
    return add(files_.read(request.path, directories_[from], request.limit.left, known), request,
               known);
}

std::optional<FileLoader::Found> FileLoader::add(ReadResult result, const Request& request,
                                                 const std::set<std::string>& known) {
    const Span span = request.span;
    // Offsets into a source are 32 bits wide.
    const bool is_addressable = result.text.size() <= 0xffffffffu - Text::kPadding;
    if (result.status == ReadStatus::ok && !is_addressable) result.status = ReadStatus::too_large;
    if (result.status != ReadStatus::ok) {
        report(result, request);
        return std::nullopt;
    }
    if (result.used_backslash) {
        diagnostics_.warning(Code::W1603, span, "write paths with `/`");
    } else if (result.differs_in_case) {
        diagnostics_.warning(Code::W1604, span,
                             fmt::format("this file is called `{}`; elsewhere the case of letters "
                                         "decides",
                                         result.path));
    } else if (result.is_absolute && !span.is_nowhere()) {
        diagnostics_.warning(Code::W1605, span, "an absolute path works on this machine only");
    }
    if (known.contains(result.identity)) return Found{std::move(result.identity), std::nullopt};
    request.limit.left -= std::min<std::uint64_t>(result.text.size(), request.limit.left);
    const SourceId id =
        sources_.add(std::move(result.path), std::move(result.text), request.included_from);
    directories_[id] = std::move(result.directory);
    identities_[id] = result.identity;
    return Found{std::move(result.identity), id};
}

void FileLoader::report(const ReadResult& result, const Request& request) {
    const Span span = request.span;
    const std::string_view written = request.path;
    if (request.need == Need::optional && result.status != ReadStatus::too_large) {
        return warn_missing(result, request);
    }
    switch (result.status) {
        case ReadStatus::ok:
            return;
        case ReadStatus::not_found:
            report_not_found(result, request);
            return;
        case ReadStatus::outside:
            diagnostics_
                .error(Code::E0605, span,
                       fmt::format("`{}` is outside the directories this scene may read", written))
                .with_help(fmt::format("if you trust the scene, allow it with `--allow {}`",
                                       result.allow));
            return;
        case ReadStatus::not_regular:
            diagnostics_.error(Code::E0604, span,
                               fmt::format("`{}` is not a file with text in it", written));
            return;
        case ReadStatus::too_large:
            report_too_large(request);
            return;
        case ReadStatus::unreadable:
            diagnostics_.error(Code::E0604, span,
                               fmt::format("`{}` cannot be read: {}", written, result.reason));
            return;
    }
}

void FileLoader::report_too_large(const Request& request) {
    SizeLimit& limit = request.limit;
    limit.is_exceeded = true;
    const bool is_first = limit.left == limit.bytes;
    diagnostics_
        .error(Code::E0516, request.span,
               is_first ? fmt::format("`{}` is larger than {} bytes", request.path, limit.bytes)
                        : fmt::format("with `{}` the files are larger than {} bytes together",
                                      request.path, limit.bytes))
        .with_help(fmt::format("raise the limit with `{} N`", limit.flag));
}

void FileLoader::report_not_found(const ReadResult& result, const Request& request) {
    const std::string_view written = request.path;
    const std::size_t places = result.searched.size();
    const std::string where = result.is_library ? " in the bundled library"
                              : places > 1      ? fmt::format(" in {} places", places)
                                                : std::string();
    Diagnostic& diagnostic = diagnostics_.error(Code::E0601, request.span,
                                                fmt::format("`{}` not found{}", written, where));
    if (!result.nearest.empty()) {
        diagnostic.with_hint(fmt::format("did you mean `{}`?", result.nearest));
    }
    if (result.is_library) {
        std::string names;
        for (const std::string& name : result.available) {
            if (!name.ends_with(".lrs")) continue;
            names += fmt::format("{}std:{}", names.empty() ? "" : ", ", name);
        }
        diagnostic.with_note(names.empty() ? "the library is missing: it belongs beside the program"
                                           : fmt::format("the library has {}", names));
    } else if (!request.span.is_nowhere()) {
        for (const std::string& place : result.searched) {
            diagnostic.with_note(fmt::format("looked for {}", place));
        }
    }
}

void FileLoader::warn_missing(const ReadResult& result, const Request& request) {
    const std::string_view written = request.path;
    if (result.status == ReadStatus::outside) {
        diagnostics_
            .warning(Code::W1701, request.span,
                     fmt::format("`{}` is outside the directories this scene may read", written))
            .with_help(
                fmt::format("if you trust the scene, allow it with `--allow {}`", result.allow));
        return;
    }
    Diagnostic& warning = diagnostics_.warning(
        Code::W1701, request.span,
        result.status == ReadStatus::not_found
            ? fmt::format("`{}` not found; the mesh does without", written)
            : fmt::format("`{}` cannot be read; the mesh does without", written));
    if (!result.nearest.empty()) {
        warning.with_hint(fmt::format("did you mean `{}`?", result.nearest));
    }
}

std::optional<scene::MeshId> FileLoader::mesh(std::string_view path, SourceId from, Span span,
                                              std::optional<double> smooth_degrees,
                                              scene::Scene& scene) {
    const auto [known, is_new] =
        mesh_identities_.try_emplace({directories_[from], std::string(path)});
    std::optional<std::string>& identity = known->second;
    const Request request{path, span, Span{}, mesh_limit_};
    if (is_new) {
        const std::optional<scene::MeshFormat> format = scene::mesh_format_of(path);
        if (!format) {
            diagnostics_
                .error(Code::E0705, span,
                       fmt::format("`{}` files are not read by this version",
                                   path.substr(path.rfind('.'))))
                .with_help("save the mesh as OBJ, PLY, glTF (.glb) or STL");
            return std::nullopt;
        }
        const std::optional<Found> found = read(request, from, mesh_files_);
        if (!found) return std::nullopt;
        identity = found->identity;
        if (found->id) {
            mesh_files_.insert(found->identity);
            meshes_by_identity_.emplace(
                found->identity, read_mesh(*format, *found->id, span, smooth_degrees, scene));
        }
    }
    if (!identity) return std::nullopt;
    std::optional<LoadedMesh>& loaded = meshes_by_identity_.at(*identity);
    if (!loaded) return std::nullopt;
    return smooth_again(*loaded, request, smooth_degrees, scene);
}

std::optional<scene::MeshId> FileLoader::smooth_again(LoadedMesh& loaded, const Request& request,
                                                      std::optional<double> smooth_degrees,
                                                      scene::Scene& scene) {
    const auto made = loaded.by_smoothness.find(smooth_degrees);
    if (made != loaded.by_smoothness.end()) return made->second;
    if (request.limit.is_exceeded) return std::nullopt;
    if (loaded.size > request.limit.left) {
        report_too_large(request);
        return std::nullopt;
    }
    request.limit.left -= loaded.size;
    const scene::MeshId first = loaded.by_smoothness.begin()->second;
    scene::Mesh mesh = scene.meshes[first.index()];
    mesh.smooth_degrees = smooth_degrees;
    if (smooth_degrees) {
        scene::smooth_by_angle(mesh, radians(*smooth_degrees));
    } else {
        mesh.normals = std::move(loaded.normals);
        mesh.normal_indices = std::move(loaded.normal_indices);
    }
    const scene::MeshId id(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    mesh_sources_[id.value] = source_of(first);
    loaded.by_smoothness.emplace(smooth_degrees, id);
    return id;
}

std::optional<SourceId> FileLoader::companion(std::string_view path, SourceId from, Span span) {
    const std::optional<Found> found =
        read({path, span, Span{}, mesh_limit_, Need::optional}, from);
    return found ? found->id : std::nullopt;
}

std::optional<image::Image> FileLoader::heights(std::string_view path, SourceId from, Span span) {
    const std::optional<Found> found = read({path, span, Span{}, mesh_limit_}, from);
    if (!found) return std::nullopt;
    const SourceId file = *found->id;
    std::string mistake;
    const std::string_view bytes = sources_[file].text.view();
    std::optional<image::Image> picture =
        image::read_image(std::as_bytes(std::span(bytes)), {}, mistake);
    if (!picture) {
        diagnostics_.error(Code::E0703, span, fmt::format("`{}`: {}", path, mistake));
    }
    sources_.release_text(file);  // its bytes are never shown
    return picture;
}

std::optional<scene::PictureId> FileLoader::picture(std::string_view path, SourceId from, Span span,
                                                    scene::Scene& scene) {
    const auto [known, is_new] = pictures_.try_emplace({directories_[from], std::string(path)});
    if (is_new) known->second = read_picture(path, from, span, Need::required, scene);
    return known->second;
}

std::optional<scene::PictureId> FileLoader::companion_picture(std::string_view path, SourceId from,
                                                              Span span, scene::Scene& scene) {
    std::pair<std::string, std::string> name{directories_[from], std::string(path)};
    const auto known = pictures_.find(name);
    if (known != pictures_.end()) return known->second;
    if (!companion_pictures_.insert(name).second) return std::nullopt;  // said once
    const auto picture = read_picture(path, from, span, Need::optional, scene);
    // Where a scene names one that is missing, it is an error.
    if (picture) pictures_.emplace(std::move(name), picture);
    return picture;
}

std::optional<scene::PictureId> FileLoader::read_picture(std::string_view path, SourceId from,
                                                         Span span, Need need,
                                                         scene::Scene& scene) {
    if (const std::string_view format = other_picture_format(path); !format.empty()) {
        if (need == Need::optional) {
            diagnostics_
                .warning(Code::W1701, span,
                         fmt::format("`{}` files are not read by this version", format))
                .with_help("save the picture as PNG or JPEG");
            return std::nullopt;
        }
        diagnostics_
            .error(Code::E0705, span,
                   fmt::format("`{}` files are not read by this version", format))
            .with_help("save the picture as PNG, JPEG, Radiance HDR or OpenEXR");
        return std::nullopt;
    }
    const std::optional<Found> found = read({path, span, Span{}, texture_limit_, need}, from);
    if (!found) return std::nullopt;
    const SourceId file = *found->id;
    const std::string_view text = sources_[file].text.view();
    std::string mistake;
    image::ReadLimits pixels{texture_pixels_left_};
    std::optional<image::Pixels> image =
        image::read_pixels(std::as_bytes(std::span(text)), pixels, mistake);
    sources_.release_text(file);
    if (!image && pixels.is_exceeded) {
        const bool is_first = texture_pixels_left_ == limits_.texture_pixels;
        diagnostics_
            .error(Code::E0516, span,
                   fmt::format("`{}`: {}{}", path, mistake,
                               is_first ? "" : " that the pictures before it leave"))
            .with_help("raise the limit with `--max-texture-pixels N`");
        return std::nullopt;
    }
    if (!image) {
        diagnostics_.error(Code::E0703, span, fmt::format("`{}`: {}", path, mistake));
        return std::nullopt;
    }
    texture_pixels_left_ -= std::uint64_t{image::width_of(*image)} * image::height_of(*image);
    if (auto* const light = std::get_if<image::Image>(&*image)) warn_of_mended(*light, path, span);
    scene::Picture picture;
    picture.srgb_mean = image::mean_color(*image, true);
    picture.linear_mean = image::mean_color(*image, false);
    picture.file = path_from_main(file);
    picture.pixels = std::move(*image);
    const scene::PictureId id(scene.pictures.size());
    scene.pictures.push_back(std::move(picture));
    return id;
}

void FileLoader::warn_of_mended(image::Image& light, std::string_view path, Span span) {
    const std::uint64_t count = image::mend_light(light);
    if (count == 0) return;
    diagnostics_.warning(
        Code::W1703, span,
        fmt::format("`{}`: {} of its {} pixels {} not light: negative, not finite or above {:g}",
                    path, count, light.pixels.size(), count == 1 ? "is" : "are",
                    double{image::kMostPictureLight}));
}

std::optional<FileLoader::LoadedMesh> FileLoader::read_mesh(scene::MeshFormat format, SourceId file,
                                                            Span span,
                                                            std::optional<double> smooth_degrees,
                                                            scene::Scene& scene) {
    const std::size_t told_before = diagnostics_.error_count() + diagnostics_.warning_count();
    LoadedMesh loaded;
    loaded.size = sources_[file].text.size();
    std::optional<scene::Mesh> mesh =
        scene::read_mesh(format, sources_, file, span, import_, diagnostics_);
    if (diagnostics_.error_count() + diagnostics_.warning_count() == told_before) {
        sources_.release_text(file);  // nothing in it will be shown
    }
    if (!mesh) return std::nullopt;
    mesh->file = path_from_main(file);
    if (smooth_degrees) {
        loaded.normals = std::exchange(mesh->normals, {});
        loaded.normal_indices = std::exchange(mesh->normal_indices, {});
        mesh->smooth_degrees = smooth_degrees;
        scene::smooth_by_angle(*mesh, radians(*smooth_degrees));
    }
    const scene::MeshId id(scene.meshes.size());
    scene.meshes.push_back(std::move(*mesh));
    mesh_sources_[id.value] = file;
    loaded.by_smoothness.emplace(smooth_degrees, id);
    return loaded;
}

}  // namespace lray::parser
