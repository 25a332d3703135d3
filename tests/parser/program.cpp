#include "tests/parser/program.h"

#include <fmt/format.h>

namespace lray::test {

namespace {

/// Without the directory, which is another each time.
std::string without(std::string text, const std::string& directory) {
    for (std::size_t at = text.find(directory); at != text.npos; at = text.find(directory)) {
        text.erase(at, directory.size());
    }
    return text;
}

}  // namespace

std::string Ran::told() const {
    std::string text = printed;
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        if (diagnostic->code == Code::W1501 || diagnostic->code == Code::W1503) continue;
        text +=
            fmt::format("{} {} {}{}\n", code_info(diagnostic->code).id,
                        place_of(loaded.sources, diagnostic->span), diagnostic->message,
                        diagnostic->count > 1 ? fmt::format(" ({} times)", diagnostic->count) : "");
    }
    return without(text, directory + "/");
}

Ran run(std::string_view scene, parser::LoadSettings settings,
        const std::vector<Companion>& companions) {
    const TempDirectory directory;
    for (const Companion& companion : companions) {
        directory.write(companion.name, companion.content);
    }
    Ran result;
    result.directory = directory.path();
    settings.print = [&](std::string_view line) {
        result.printed += line;
        result.printed += '\n';
    };
    FileAccess files;
    files.set_library(LRAY_SOURCE_DIR "/parser/std");
    parser::LoadResult loaded = parser::load(directory.write("main.lrs", scene), settings, files,
                                             result.loaded.sources, result.loaded.diagnostics);
    result.loaded.scene = std::move(loaded.scene);
    result.usage_mistakes = std::move(loaded.usage_mistakes);
    result.params = std::move(loaded.params);
    return result;
}

std::string told_by(std::string_view scene, const parser::LoadSettings& settings,
                    const std::vector<Companion>& companions) {
    return run(scene, settings, companions).told();
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    for (std::size_t i = 0; i < count; ++i) result += text;
    return result;
}

}  // namespace lray::test
