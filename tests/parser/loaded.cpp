#include "tests/parser/loaded.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace lray::test {

std::string Loaded::codes() const {
    std::string codes;
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        if (!codes.empty()) codes += ' ';
        codes += code_info(diagnostic->code).id;
    }
    return codes;
}

std::string Loaded::text() const {
    std::string text;
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        text += fmt::format("{} {} {}\n", code_info(diagnostic->code).id,
                            place_of(sources, diagnostic->span), diagnostic->message);
    }
    return text;
}

Loaded load_file(const std::string& path, const parser::LoadSettings& settings,
                 const WarningLevels& levels) {
    Loaded loaded;
    loaded.diagnostics = Diagnostics(levels);
    FileAccess files;
    files.set_library(LRAY_SOURCE_DIR "/parser/std");
    loaded.scene = parser::load(path, settings, files, loaded.sources, loaded.diagnostics).scene;
    return loaded;
}

WarningLevels all_warnings() {
    WarningLevels levels;
    static_cast<void>(levels.set("all", WarningLevel::warn));
    return levels;
}

std::optional<scene::World> flatten_and_lint(Loaded& loaded, const scene::FlattenLimits& limits,
                                             const scene::LintSettings& settings) {
    if (!loaded.scene) return std::nullopt;
    auto world = scene::flatten(*loaded.scene, limits, loaded.diagnostics);
    if (world) scene::lint(*loaded.scene, *world, settings, loaded.diagnostics);
    return world;
}

Loaded load_text(std::string_view text, const parser::LoadSettings& settings,
                 const std::vector<Companion>& companions) {
    const TempDirectory directory;
    for (const Companion& companion : companions)
        directory.write(companion.name, companion.content);
    return load_file(directory.write("main.lrs", text), settings);
}

std::string place_of(const Sources& sources, Span span) {
    if (span.is_nowhere()) return "-";
    const Position at = sources.position(span);
    if (span.source == 0) return fmt::format("{}:{}", at.line, at.column);
    return fmt::format("{}:{}:{}", sources[span.source].path, at.line, at.column);
}

Examples::Examples() {
    namespace fs = std::filesystem;
    const fs::path examples = LRAY_SOURCE_DIR "/examples";
    fs::copy(examples, directory_.path(), fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(examples)) {
        if (entry.path().extension() != ".lrs") continue;
        names_.push_back(entry.path().lexically_relative(examples).string());
    }
    std::sort(names_.begin(), names_.end());
}

Loaded Examples::load_changed(const std::string& name, std::string_view changed,
                              const parser::LoadSettings& settings) const {
    const std::string before = text(name);
    directory_.write(name, changed);
    Loaded loaded = load_file(directory_.path(name), settings);
    directory_.write(name, before);
    return loaded;
}

}  // namespace lray::test
