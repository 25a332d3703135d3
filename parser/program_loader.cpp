#include "parser/program_loader.h"

#include <fmt/format.h>

#include "parser/nff_items.h"

namespace lray::parser {

std::span<Item* const> ProgramLoader::parse(SourceId source) {
    if (is_nff(path(source))) return nff_items(source, context_, limits_, diagnostics_);
    ParsedFile file = lray::parser::parse(source, context_, diagnostics_);
    is_structure_known_ = is_structure_known_ && file.is_structure_known;
    open_.push_back(source);
    for (IncludeItem* item : file.includes) include(*item);
    for (ImportItem* item : file.imports) import(*item);
    open_.pop_back();
    return file.items;
}

void ProgramLoader::include(IncludeItem& item) {
    const std::optional<SourceId> source = open(*item.path);
    if (!source) return;
    // What runs any number of times must not be read into the scene once.
    const bool is_fast = context_.use_literal_fast_path;
    context_.use_literal_fast_path = is_fast && !item.runs_any_times;
    item.items = parse(*source);
    context_.use_literal_fast_path = is_fast;
    item.is_loaded = true;
}

void ProgramLoader::import(ImportItem& item) {
    const std::optional<SourceId> source = open(*item.path);
    if (!source) return;
    Module*& known = modules_[files_.identity(*source)];
    if (known == nullptr) {
        Module* const module = context_.arena.make<Module>();
        known = module;  // before its own imports are read
        module->source = *source;
        module->items = is_nff(path(*source)) ? nff_names(*source, context_, limits_, diagnostics_)
                                              : parse(*source);
    }
    item.module = known;
}

// Reads the file that is named here, if it may be part of the program here.
std::optional<SourceId> ProgramLoader::open(const StringExpr& path) {
    const std::optional<SourceId> source = files_.scene(path.value, open_.back(), path.span);
    if (!source) return std::nullopt;
    if (is_open(*source)) {
        report_cycle(*source, path.span);
        return std::nullopt;
    }
    if (open_.size() > limits_.include_depth) {
        diagnostics_
            .error(Code::E0515, path.span,
                   fmt::format("includes are nested more than {} deep", limits_.include_depth))
            .with_help("raise the limit with `--max-include-depth N`");
        return std::nullopt;
    }
    return source;
}

bool ProgramLoader::is_open(SourceId source) const {
    for (const SourceId opened : open_) {
        if (files_.is_same_file(opened, source)) return true;
    }
    return false;
}

void ProgramLoader::report_cycle(SourceId source, Span span) {
    std::string chain;
    bool is_in_cycle = false;
    for (const SourceId opened : open_) {
        is_in_cycle = is_in_cycle || files_.is_same_file(opened, source);
        if (is_in_cycle) chain += fmt::format("{} -> ", path(opened));
    }
    chain += path(source);
    const bool is_itself = files_.is_same_file(open_.back(), source);
    diagnostics_
        .error(Code::E0602, span,
               is_itself ? fmt::format("{} includes itself", path(source))
                         : fmt::format("{} is already being included", path(source)))
        .with_note(fmt::format("the chain is {}", chain));
}

}  // namespace lray::parser
