#include "parser/evaluate/evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parser/evaluate/deep_stack.h"
#include "parser/evaluate/evaluator_state.h"

namespace lray::parser {

void evaluate(std::span<Item* const> items, const Environment& environment, scene::Scene& scene,
              Diagnostics& diagnostics) {
    run_on_deep_stack([&](const char* stack_end) {
        Evaluator(environment, scene, diagnostics, stack_end).run(items);
    });
}

Evaluator::Evaluator(const Environment& environment, scene::Scene& scene, Diagnostics& diagnostics,
                     const char* stack_end)
    : environment_(environment),
      checked_(environment.checked),
      symbols_(environment.symbols),
      sources_(environment.sources),
      files_(environment.files),
      memory_(budget_),
      scene_(scene),
      diagnostics_(diagnostics),
      globals_(environment.checked.global_count),
      is_imported_(environment.checked.module_count),
      range_builtin_(find_builtin("range").value_or(kNoSlot)),
      assert_builtin_(find_builtin("assert").value_or(kNoSlot)),
      stack_end_(stack_end) {
    const LoadLimits& limits = environment.settings.limits;
    budget_.steps = limits.steps;
    budget_.max_steps = limits.steps;
    budget_.value_bytes = limits.value_bytes;
    budget_.max_value_bytes = limits.value_bytes;
    budget_.max_list_size = limits.list_size;
}

void Evaluator::run(std::span<Item* const> list) {
    OpenBlock root(block_schema(BlockKind::group), Span{});
    slots_.resize(checked_.frame_size);
    frame_ = slots_.data();
    top_ = checked_.frame_size;
    diagnostics_.explain_with([this](Diagnostic& diagnostic) { explain_calls(diagnostic); });
    const std::uint64_t limit = environment_.settings.limits.nodes;
    if (scene_.nodes.size() > limit) too_many_nodes(scene_.nodes[limit].span);  // all literals
    items(list, root);
    diagnostics_.explain_with({});
    scene_.root = add_node(root, scene::NodeKind::group, scene_.groups.size(), nullptr);
    scene_.groups.push_back({std::move(root.children)});
}

// The calls that are open, the innermost first.
void Evaluator::explain_calls(Diagnostic& diagnostic) {
    constexpr std::uint64_t kStepsPerCall = 8;  // to tell a call is work, however often it is told
    budget_.steps -= std::min(budget_.steps, kStepsPerCall * calls_.size());
    for (std::size_t i = calls_.size(); i-- > 0;) {
        const Symbol name = calls_[i].function->name;
        diagnostic.with_call(calls_[i].span,
                             std::string(name == kNoSymbol ? "fn" : symbols_.text(name)));
    }
}

void Evaluator::print(std::string_view line, Span span) {
    const LoadSettings& settings = environment_.settings;
    const std::uint64_t limit = settings.limits.printed_bytes;
    if (printed_bytes_ > limit) return;
    printed_bytes_ += line.size() + 1;
    if (printed_bytes_ > limit) {
        budget_.spend();
        error(Code::E0517, span, fmt::format("the scene prints more than {} bytes", limit))
            .with_help("raise the limit with `--max-printed-bytes N`");
        return;
    }
    if (settings.print) settings.print(line);
}

}  // namespace lray::parser
