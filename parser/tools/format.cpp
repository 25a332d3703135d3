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

/// Tells what is wrong as it is told when the scene is loaded: the parser knows more about what was
/// meant than the formatter.
void report_as_parser(SourceId source, Sources& sources, const LoadLimits& limits,
                      Diagnostics& diagnostics) {
    scene::Scene scene;
    Symbols symbols;
    Arena arena;
    std::vector<OwnedNumbers> long_lists;
    ParseContext context{sources, symbols, arena, scene, long_lists, limits.nesting, true};
    parse(source, context, diagnostics);
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
    report_as_parser(source, sources, limits, diagnostics);
    if (!diagnostics.has_errors()) {
        const std::uint32_t at = reader.failure_offset();
        diagnostics.error(Code::E0104, Span::make(source, at, at), "brackets do not match here");
    }
    return std::nullopt;
}

std::optional<FormattedFile> format_file(std::string_view path, const LoadLimits& limits,
                                         FileAccess& files, Sources& sources,
                                         Diagnostics& diagnostics) {
    const std::optional<SourceId> source =
        FileLoader(files, sources, limits, diagnostics).main_scene(path);
    if (!source) return std::nullopt;
    std::optional<std::string> text = format(*source, sources, limits, diagnostics);
    if (!text) return std::nullopt;
    return FormattedFile{*source, std::move(*text)};
}

}  // namespace lray::parser
