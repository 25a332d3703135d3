#include "parser/check/checker.h"

#include "parser/check/checker_state.h"

namespace lray::parser {

std::uint32_t FileChecker::check(std::span<Item* const> list, Module* module) {
    context_ = &program_.functions.add(nullptr, nullptr);
    scopes_.open(list, *context_);
    declare_functions(list);
    items(list, Place{Place::Kind::file, nullptr, scopes_.depth()});
    if (module != nullptr) {
        std::unordered_map<Symbol, Variable>& exports = program_.exports[module];
        for (Variable& variable : scopes_.innermost()) {
            variable.is_used = true;
            exports.try_emplace(variable.name, variable);
        }
    } else {
        unused_materials(list);
    }
    close_scope();
    return context_->frame_size;
}

Checked check(std::span<Item* const> items, std::span<const scene::Node> nodes, Symbols& symbols,
              const Sources& sources, std::uint32_t max_nesting, Arena& arena,
              Diagnostics& diagnostics) {
    Program program{nodes, symbols, sources, max_nesting, arena, diagnostics};
    program.is_too_deep = diagnostics.has_limit_errors();
    FileChecker checker(program);
    program.checked.frame_size = checker.check(items, nullptr);
    program.checked.function_count = program.functions.function_count();
    program.functions.resolve(arena, program.checked.uses, diagnostics);
    for (const auto& [call, use] : program.unused_calls) {
        if (program.checked.uses[use].function->has_effects) continue;
        diagnostics.error(Code::E0408, call->span, "the value of this call is not used")
            .with_help("give it a name, `let a = ...`, or place a node it returns: `f(3) { }`");
    }
    return std::move(program.checked);
}

}  // namespace lray::parser
