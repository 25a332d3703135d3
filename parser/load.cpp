#include "parser/load.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "parser/arena.h"
#include "parser/check/checker.h"
#include "parser/evaluate/evaluator.h"
#include "parser/file_loader.h"
#include "parser/symbols.h"
#include "parser/syntax/parser.h"

namespace lray::parser {

namespace {

/// Parses files and, one inside the other, the files they include.
class IncludeLoader {
 public:
    IncludeLoader(ParseContext& context, FileLoader& files, const LoadLimits& limits,
                  Diagnostics& diagnostics)
        : context_(context), files_(files), limits_(limits), diagnostics_(diagnostics) {}

    /// Returns the items of a source, with those of its includes below them. Recurses as deep as
    /// the include limit allows.
    std::span<Item* const> parse_with_includes(SourceId source) {
        ParsedFile file = parse(source, context_, diagnostics_);
        is_structure_known_ = is_structure_known_ && file.is_structure_known;
        open_.push_back(source);
        for (IncludeItem* include : file.includes) load(*include);
        open_.pop_back();
        return file.items;
    }

    bool is_structure_known() const { return is_structure_known_; }

 private:
    void load(IncludeItem& include) {
        const SourceId from = open_.back();
        const Span span = include.path->span;
        const std::optional<SourceId> source = files_.scene(include.path->value, from, span);
        if (!source) return;
        if (is_open(*source)) {
            report_cycle(*source, span);
            return;
        }
        if (open_.size() > limits_.include_depth) {
            diagnostics_
                .error(Code::E0515, span,
                       fmt::format("includes are nested more than {} deep", limits_.include_depth))
                .with_help("raise the limit with `--max-include-depth N`");
            return;
        }
        const bool is_fast = context_.use_literal_fast_path;
        context_.use_literal_fast_path = is_fast && !include.runs_any_times;
        include.items = parse_with_includes(*source);
        context_.use_literal_fast_path = is_fast;
        include.is_loaded = true;
    }

    // Two names of one file (a link) are not recognised as a cycle; the depth limit ends it.
    bool is_open(SourceId source) const {
        for (const SourceId opened : open_) {
            if (path(opened) == path(source)) return true;
        }
        return false;
    }

    const std::string& path(SourceId source) const { return context_.sources[source].path; }

    void report_cycle(SourceId source, Span span) {
        std::string chain;
        bool is_in_cycle = false;
        for (const SourceId opened : open_) {
            is_in_cycle = is_in_cycle || path(opened) == path(source);
            if (is_in_cycle) chain += fmt::format("{} -> ", path(opened));
        }
        chain += path(source);
        const bool is_itself = path(open_.back()) == path(source);
        diagnostics_
            .error(Code::E0602, span,
                   is_itself ? fmt::format("{} includes itself", path(source))
                             : fmt::format("{} is already being included", path(source)))
            .with_note(fmt::format("the chain is {}", chain));
    }

    ParseContext& context_;
    FileLoader& files_;
    const LoadLimits& limits_;
    Diagnostics& diagnostics_;
    std::vector<SourceId> open_;
    bool is_structure_known_ = true;
};

void warn_of_gaps(const scene::Scene& scene, SourceId main, Diagnostics& diagnostics) {
    const Span begin = Span::make(main, 0, 0);
    const scene::Node& root = scene.node(scene.root);
    if (scene.groups[root.index].children.empty()) {
        diagnostics.warning(Code::W1503, begin, "the scene is empty: there is no shape in it");
    } else if (scene.cameras.empty()) {
        diagnostics
            .warning(Code::W1501, begin, "there is no camera; a view of the whole scene is used")
            .with_help("add `camera { position: [0, 2, 6], look_at: [0, 0, 0] }`");
    }
}

}  // namespace

LoadResult load(std::string_view path, const LoadSettings& settings, FileAccess& files,
                Sources& sources, Diagnostics& diagnostics) {
    const LoadLimits& limits = settings.limits;
    FileLoader loader(files, sources, limits, diagnostics);
    const std::optional<SourceId> main = loader.main_scene(path);
    if (!main) return {};

    scene::Scene scene;
    Symbols symbols;
    Arena arena;
    std::vector<OwnedNumbers> long_lists;
    ParseContext context{
        sources, symbols, arena, scene, long_lists, limits.nesting, settings.use_literal_fast_path};
    IncludeLoader includes(context, loader, limits, diagnostics);
    const std::span<Item* const> program = includes.parse_with_includes(*main);
    if (!includes.is_structure_known()) return {};
    const Checked checked = check(program, symbols, sources, limits.nesting, arena, diagnostics);
    if (diagnostics.has_errors()) return {};
    evaluate(program, checked, symbols, sources, loader, limits, scene, diagnostics);
    if (diagnostics.has_errors()) return {};
    warn_of_gaps(scene, *main, diagnostics);
    return {std::move(scene), {}};
}

}  // namespace lray::parser
