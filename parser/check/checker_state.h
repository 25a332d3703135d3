// The checker of one file: its state and its passes over items, names, blocks and expressions.
// Used by checker_*.cpp alone.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/check/check_block.h"
#include "parser/check/checker.h"
#include "parser/check/scopes.h"

namespace lray::parser {

/// What the files of a program share while they are checked.
struct Program {
    std::span<const scene::Node> nodes{};  // of literals
    Symbols& symbols;
    const Sources& sources;
    std::uint32_t max_nesting = 0;
    Arena& arena;
    Diagnostics& diagnostics;
    Checked checked{};
    FunctionUses functions{};
    std::unordered_map<const Module*, std::unordered_map<Symbol, Variable>> exports{};
    std::unordered_map<std::uint64_t, const BlockSchema*> schemas{};        // of values, by place
    std::vector<std::pair<const CallExpr*, std::uint32_t>> unused_calls{};  // with their use
    std::vector<std::string_view> broken_names{};  // of definitions whose header is a mistake
    std::uint32_t nesting = 0;
    bool is_too_deep = false;  // reported, here or by the parser
};

/// What the items at hand stand in.
struct Place {
    enum class Kind : std::uint8_t { file, block, function };

    Kind kind = Kind::file;
    const BlockSchema* schema = nullptr;  // of the block; null: none
    std::size_t scope = 0;                // depth of its braces
};

class FileChecker {
 public:
    explicit FileChecker(Program& program, std::string prefix = {})
        : program_(program),
          prefix_(std::move(prefix)),
          symbols_(program.symbols),
          sources_(program.sources),
          diagnostics_(program.diagnostics) {}

    /// Checks the items of the main file or an import; returns the size of its frame.
    std::uint32_t check(std::span<Item* const> list, Module* module);

 private:
    // checker_items.cpp
    void items(std::span<Item* const> list, const Place& place);
    void item(Item& item, const Place& place);
    void let(LetItem& item);
    void param(LetItem& item);
    void include(IncludeItem& item, const Place& place);
    void property(PropertyItem& item, const Place& place);
    void value_of(const PropertySchema& property, const Expr& expr);
    void assignment(AssignmentItem& item, const Place& place);
    void call_item(const CallItem& item);
    void unreachable(std::span<Item* const> list);

    // checker_flow.cpp
    void conditional(ConditionalItem& item, const Place& place);
    void for_loop(ForItem& item, const Place& place);
    void while_loop(WhileItem& item, const Place& place);
    Context::Loop loop_body(const Body& body, const Place& place, LoopInfo& info);
    void constant_condition(const Expr& condition);
    void constant_random(const CallExpr& expr, std::string_view name);
    std::uint32_t element_name(Symbol name, Span span);

    // checker_functions.cpp
    void declare_functions(std::span<Item* const> list);
    void declare_function(FunctionItem& item);
    void function_body(Function& function);
    const BlockSchema* component_schema(const Function& function);
    void parameter_names(const Function& function);
    void import(ImportItem& item);
    void member(MemberExpr& expr);
    void imported(MemberExpr& expr, const Variable& alias);
    std::uint32_t use(Function& function) { return program_.functions.use(function, *context_); }

    // checker_names.cpp
    void name(NameExpr& expr, bool is_block_head);
    bool resolve(NameExpr& expr, Variable& variable);
    bool resolve_later(NameExpr& expr);
    void unknown_name(const NameExpr& expr, bool is_block_head);
    void new_name(Symbol name, Span span);
    Variable& declare(Symbol name, Span span, Meaning meaning);
    Variable& declare_value(Symbol name, Span span);
    void place_value(Variable& variable);
    void close_scope();
    void unused_materials(std::span<Item* const> list);

    // checker_blocks.cpp
    void placed_block(const BlockItem& item, const Place& parent);
    void top_level_block(const BlockExpr& placed, const BlockSchema& schema);
    const BlockSchema* schema_of(const Expr& expr) const;
    void know_schema(Span definition, const BlockSchema* schema);
    void literals(LiteralsItem& item);
    void material_of_literals(NameExpr& name);
    void block(BlockExpr& expr, bool is_placed);
    void head_and_body(BlockExpr& expr, bool is_placed);

    // checker_expr.cpp
    bool fits_nesting(Span span);
    void expression(Expr& expr);
    void parts_of(Expr& expr);
    void comprehension(ComprehensionExpr& expr);
    void call(CallExpr& expr);
    void call_of_name(CallExpr& expr, NameExpr& callee);
    void called(CallExpr& expr, const NameExpr& callee);
    std::string as_properties(const CallExpr& expr) const;

    Diagnostic& error(Code code, Span span, std::string message) {
        return diagnostics_.error(code, span, std::move(message));
    }
    std::string_view text(const Expr& expr) const { return sources_.text(expr.span); }

    Program& program_;
    std::string prefix_;  // of the names of params
    Symbols& symbols_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
    Scopes scopes_;
    Context* context_ = nullptr;
    Span first_render_{};
    Span first_info_{};
    bool has_failed_include_ = false;  // what is unknown may stand in the file that is missing
};

}  // namespace lray::parser
