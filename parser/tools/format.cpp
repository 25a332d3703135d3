#include "parser/tools/format.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/assert.h"
#include "parser/arena.h"
#include "parser/file_loader.h"
#include "parser/symbols.h"
#include "parser/syntax/parser.h"
#include "parser/tools/format_layout.h"
#include "parser/tools/format_pieces.h"

namespace lray::parser {

namespace {

/// Reads a scene as it is read when it is loaded. The meaning of one that the parser does not
/// understand may hang on how it is laid out.
bool is_understood(SourceId source, Sources& sources, const LoadLimits& limits,
                   Diagnostics& diagnostics) {
    scene::Scene scene;
    Symbols symbols;
    Arena arena;
    std::vector<OwnedNumbers> long_lists;
    ParseContext context{sources, symbols, arena, scene, long_lists, limits.nesting, true};
    parse(source, context, diagnostics);
    return !diagnostics.has_errors();
}

}  // namespace

std::optional<std::string> format(SourceId source, Sources& sources, const LoadLimits& limits,
                                  Diagnostics& diagnostics) {
    PieceReader reader(sources, source, limits.nesting);
    Layout layout(sources[source].text.view(), reader, limits.scene_bytes);
    switch (layout.run()) {
        case LayoutEnd::done:
            return layout.take_text();
        case LayoutEnd::too_large:
            diagnostics
                .error(
                    Code::E0516, {},
                    fmt::format("formatted, the scene is larger than {} bytes", limits.scene_bytes))
                .with_help("raise the limit with `--max-scene-bytes N`");
            return std::nullopt;
        case LayoutEnd::failed:
            break;
    }
    if (is_understood(source, sources, limits, diagnostics)) {
        const std::uint32_t at = reader.failure_offset();
        diagnostics.error(Code::E0104, Span::make(source, at, at), "brackets do not match here");
    }
    return std::nullopt;
}

std::optional<FormattedFile> format_file(std::string_view path, const LoadLimits& limits,
                                         FileAccess& files, Sources& sources,
                                         Diagnostics& diagnostics) {
    const std::optional<SourceId> source =
        FileLoader(files, sources, limits, {}, diagnostics).main_scene(path);
    if (!source || !is_understood(*source, sources, limits, diagnostics)) return std::nullopt;
    std::optional<std::string> text = format(*source, sources, limits, diagnostics);
    if (!text) return std::nullopt;
    return FormattedFile{*source, std::move(*text)};
}

}  // namespace lray::parser
