#include "scene/formats/import_mesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "base/did_you_mean.h"
#include "scene/formats/import_answer.h"
#include "scene/formats/run_importer.h"

namespace lray::scene {

namespace {

constexpr std::array<std::string_view, 7> kEndings = {"3ds",  "dae", "fbx", "glb",
                                                      "gltf", "off", "stl"};

/// Tells what became of one file.
class ImportReport {
 public:
    ImportReport(std::string_view path, std::string_view ending, Span span,
                 const ImportSettings& settings, Diagnostics& diagnostics)
        : path_(path),
          ending_(ending),
          span_(span),
          settings_(settings),
          diagnostics_(diagnostics) {}

    void no_program() {
        diagnostics_
            .error(Code::E0705, span_,
                   fmt::format("`.{}` files are read by a program that this lray was built without",
                               ending_))
            .with_help("save the mesh as OBJ or PLY; or install Assimp and build lray again");
    }
    void no_faces() {
        diagnostics_.error(Code::E0704, span_, fmt::format("`{}` has no faces", path_));
    }
    void failed(const ImportFailure& failure) {
        if (failure.kind == wire::Failure::out_of_memory) return too_much();
        Diagnostic& diagnostic = diagnostics_.error(
            Code::E0701, span_,
            fmt::format("`{}` is not understood: {}", path_,
                        failure.reason.empty() ? "no reason is known" : failure.reason));
        if (ending_ == "gltf") {
            diagnostic.with_help(
                "a .gltf is read alone, without files it names; save it as .glb, which holds all");
        }
    }
    void ended(ImporterEnd end) {
        switch (end) {
            case ImporterEnd::answered:
                return wrong("has answered what makes no sense");
            case ImporterEnd::failed:
                return wrong("has failed");
            case ImporterEnd::crashed:
                return wrong("crashed");
            case ImporterEnd::forbidden:
                return wrong("was stopped: it did what an importer has no need of");
            case ImporterEnd::not_started:
                return wrong("could not be started");
            case ImporterEnd::too_much:
                return too_much();
            case ImporterEnd::out_of_time:
                break;
        }
        diagnostics_
            .error(Code::E0516, span_,
                   fmt::format("`{}` is not imported after {} seconds", path_, settings_.seconds))
            .with_help("raise the limit with `--max-import-seconds N`");
    }

 private:
    void wrong(std::string_view what) {
        diagnostics_.error(
            Code::E0701, span_,
            fmt::format("the importer of .{} files {} on `{}`", ending_, what, path_));
    }
    void too_much() {
        diagnostics_
            .error(
                Code::E0516, span_,
                fmt::format("`{}` needs more than {} bytes to be imported", path_, settings_.bytes))
            .with_help("raise the limit with `--max-import-bytes N`");
    }

    std::string_view path_;
    std::string_view ending_;
    Span span_;
    const ImportSettings& settings_;
    Diagnostics& diagnostics_;
};

/// glTF says that its colours are linear; others say nothing, and mean what a screen shows.
ColorCoding coding_of(std::string_view ending) {
    return ending.starts_with("gl") ? ColorCoding::linear : ColorCoding::srgb;
}

}  // namespace

std::string_view imported_ending(std::string_view path) {
    const std::size_t point = path.rfind('.');
    if (point == path.npos) return {};
    const std::string_view ending = path.substr(point + 1);
    const auto* const known =
        std::find_if(kEndings.begin(), kEndings.end(),
                     [&](std::string_view one) { return edit_distance(ending, one, 0) == 0; });
    return known == kEndings.end() ? std::string_view{} : *known;
}

std::optional<Mesh> import_mesh(const Sources& sources, SourceId file, Span loaded_at,
                                const ImportSettings& settings, Diagnostics& diagnostics) {
    const std::string& path = sources[file].path;
    const std::string_view ending = imported_ending(path);
    ImportReport report(path, ending, loaded_at, settings, diagnostics);
    if (settings.program.empty()) {
        report.no_program();
        return {};
    }
    if (sources[file].text.size() == 0) {
        report.failed({wire::Failure::not_understood, "it is empty"});
        return {};
    }
    const ImporterRun run = run_importer(settings, ending, sources[file].text.view());
    if (run.end != ImporterEnd::answered) {
        report.ended(run.end);
        return {};
    }
    auto answer = read_import_answer(run.answer, coding_of(ending));
    if (!answer) {
        report.ended(run.end);
        return {};
    }
    if (const auto* failure = std::get_if<ImportFailure>(&*answer)) {
        report.failed(*failure);
        return {};
    }
    Mesh& mesh = std::get<Mesh>(*answer);
    if (mesh.triangles.empty()) {
        report.no_faces();
        return {};
    }
    return std::move(mesh);
}

}  // namespace lray::scene
