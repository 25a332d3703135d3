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

Loaded load_file(const std::string& path, const parser::LoadLimits& limits) {
    Loaded loaded;
    FileAccess files;
    loaded.scene = parser::load(path, limits, files, loaded.sources, loaded.diagnostics);
    return loaded;
}

Loaded load_text(std::string_view text, const parser::LoadLimits& limits,
                 const std::vector<Companion>& companions) {
    const TempDirectory directory;
    for (const Companion& companion : companions)
        directory.write(companion.name, companion.content);
    return load_file(directory.write("main.lrs", text), limits);
}

std::string place_of(const Sources& sources, Span span) {
    if (span.is_nowhere()) return "-";
    const Position at = sources.position(span);
    if (span.source == 0) return fmt::format("{}:{}", at.line, at.column);
    return fmt::format("{}:{}:{}", sources[span.source].path, at.line, at.column);
}

std::vector<std::string> example_paths() {
    std::vector<std::string> paths;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(LRAY_SOURCE_DIR "/examples")) {
        if (entry.path().extension() == ".lrs") paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace lray::test
