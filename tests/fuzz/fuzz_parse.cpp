// Fuzzes the lexer, the parser and the checker alone: what no file and no running program slows
// down.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/arena.h"
#include "parser/check/checker.h"
#include "parser/symbols.h"
#include "parser/syntax/literal_block.h"
#include "parser/syntax/parser.h"
#include "scene/scene.h"

namespace {

using namespace lray;

struct Outcome {
    bool is_structure_known = false;
    bool has_syntax_errors = false;
    std::size_t item_count = 0;
    std::size_t node_count = 0;
};

/// An item lies in its text, and neighbours in their order; those of a `literals` item are nodes
/// that were made, and name the same material.
void check_items(std::span<parser::Item* const> items, const scene::Scene& scene,
                 const Sources& sources, std::size_t size) {
    std::uint32_t begin = 0;
    for (const parser::Item* item : items) {
        LRAY_ASSERT(item->span.offset >= begin && item->span.offset <= size);
        begin = item->span.offset;
        if (item->kind != parser::ItemKind::literals) continue;
        const auto& literals = static_cast<const parser::LiteralsItem&>(*item);
        LRAY_ASSERT(literals.first_node + std::uint64_t{literals.count} <= scene.nodes.size());
        if (literals.material == nullptr) continue;
        const std::string_view name = sources.text(literals.material->span);
        for (std::uint32_t i = 0; i < literals.count; ++i) {
            const Span node = scene.nodes[literals.first_node + i].span;
            LRAY_ASSERT(sources.text(parser::material_name(node, sources)) == name);
        }
    }
}

Outcome parse_and_check(std::string_view text, bool use_literal_fast_path) {
    Sources sources;
    Diagnostics diagnostics;
    parser::Symbols symbols;
    parser::Arena arena;
    scene::Scene scene;
    std::vector<parser::OwnedNumbers> long_lists;
    const SourceId source = sources.add("fuzz.lrs", Text(text));
    parser::ParseContext context{
        sources, symbols, arena, scene, long_lists, 256, use_literal_fast_path};
    const parser::ParsedFile file = parser::parse(source, context, diagnostics);
    LRAY_ASSERT(file.is_structure_known || diagnostics.has_errors());
    check_items(file.items, scene, sources, text.size());
    Outcome outcome{file.is_structure_known, diagnostics.has_errors(), file.items.size(),
                    scene.nodes.size()};
    // Imports and includes have no file here: they count as reported.
    if (file.is_structure_known) {
        parser::check(file.items, scene.nodes, symbols, sources, 256, arena, diagnostics);
    }
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        LRAY_ASSERT(diagnostic->span.is_nowhere() || diagnostic->span.offset <= text.size());
    }
    return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Outcome fast = parse_and_check(text, true);
    const Outcome whole = parse_and_check(text, false);
    LRAY_ASSERT(whole.node_count == 0);
    // Where a mistake follows a literal block the recovery may differ, not that there is one.
    LRAY_ASSERT(fast.has_syntax_errors == whole.has_syntax_errors);
    return 0;
}
