#include "parser/load.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "parser/arena.h"
#include "parser/blocks/read_animation.h"
#include "parser/check/checker.h"
#include "parser/definitions.h"
#include "parser/evaluate/evaluator.h"
#include "parser/file_loader.h"
#include "parser/nff_items.h"
#include "parser/program_loader.h"
#include "parser/symbols.h"
#include "parser/syntax/parser.h"

namespace lray::parser {

namespace {

void warn_of_gaps(const scene::Scene& scene, SourceId main, bool is_nff, Diagnostics& diagnostics) {
    const Span begin = Span::make(main, 0, 0);
    const scene::Node& root = scene.node(scene.root);
    if (scene.groups[root.index].children.empty()) {
        diagnostics.warning(Code::W1503, begin, "the scene is empty: there is no shape in it");
    } else if (scene.cameras.empty()) {
        diagnostics
            .warning(Code::W1501, begin, "there is no camera; a view of the whole scene is used")
            .with_help(is_nff ? "add a view, like `v from 0 2 6 at 0 0 0 up 0 1 0 angle 45`"
                              : "add `camera { position: [0, 2, 6], look_at: [0, 0, 0] }`");
    }
}

}  // namespace

LoadResult load(std::string_view path, const LoadSettings& settings, FileAccess& files,
                Sources& sources, Diagnostics& diagnostics) {
    const LoadLimits& limits = settings.limits;
    FileLoader loader(files, sources, limits, settings.importer, diagnostics);
    const std::optional<SourceId> main = loader.main_scene(path);
    if (!main) return {};

    scene::Scene scene;
    Symbols symbols;
    Arena arena;
    std::vector<OwnedNumbers> long_lists;
    ParseContext context{
        sources, symbols, arena, scene, long_lists, limits.nesting, settings.use_literal_fast_path};
    ProgramLoader program(context, loader, limits, diagnostics);
    const std::span<Item* const> items = program.parse(*main);
    if (!program.is_structure_known()) return {};
    const Checked checked =
        check(items, scene.nodes, symbols, sources, limits.nesting, arena, diagnostics);
    scene.animation = read_animation(items, symbols, diagnostics);
    if (diagnostics.has_errors()) return {};

    LoadResult result;
    const scene::Animation animation = scene.animation.value_or(scene::Animation{});
    const double time = animation.start + settings.frame / animation.fps;
    Environment environment{checked, symbols, sources, loader, settings, time, {}, {}};
    environment.usage_mistakes = &result.usage_mistakes;
    environment.params =
        read_definitions(settings.definitions, checked, context, result.usage_mistakes);
    if (!result.usage_mistakes.empty()) return result;
    ListedParams params(symbols);
    environment.listed_params = &params;
    evaluate(items, environment, scene, diagnostics);
    result.params = params.take();
    if (diagnostics.has_errors() || !result.usage_mistakes.empty()) return result;
    warn_of_gaps(scene, *main, is_nff(sources[*main].path), diagnostics);
    result.scene = std::move(scene);
    return result;
}

}  // namespace lray::parser
