// The evaluator's state: what a block gathers while it runs, and the passes over items, blocks and
// expressions. Used by evaluator_*.cpp alone.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "parser/arena.h"
#include "parser/blocks/build_shape.h"
#include "parser/blocks/property_values.h"
#include "parser/builtins/builtins.h"
#include "parser/evaluate/evaluator.h"
#include "parser/values/operators.h"

namespace lray::parser {

/// A block while its items are evaluated.
struct OpenBlock {
    explicit OpenBlock(const BlockSchema& block_schema, Span block_span)
        : schema(block_schema), span(block_span), values(block_schema.properties) {}

    const BlockSchema& schema;
    Span span{};
    PropertyValues values;
    std::array<Span, kMaxProperties> value_spans{};
    std::vector<scene::NodeId> children{};
    Transform transform{};
    bool has_steps = false;
    std::optional<scene::MaterialId> material_id{};
    bool visible = true;
    bool casts_shadow = true;
    bool is_poisoned = false;  // a property could not be evaluated: nothing is made

    // For W1301: the last `scale` behind a `translate` and before any other one.
    bool has_translated = false;
    Span scale_after_translate{};
};

class Evaluator : public Runtime {
 public:
    Evaluator(const Checked& checked, const Symbols& symbols, const Sources& sources,
              FileLoader& files, const LoadLimits& limits, scene::Scene& scene,
              Diagnostics& diagnostics)
        : checked_(checked),
          symbols_(symbols),
          sources_(sources),
          files_(files),
          budget_{limits.steps,       limits.value_bytes, limits.steps,
                  limits.value_bytes, limits.list_size,   false},
          scene_(scene),
          diagnostics_(diagnostics),
          variables_(checked.variables.size(), Value::poison()) {}

    void run(std::span<Item* const> items);

    Value call_function(const Value&, std::span<const Value>, Span) override { return {}; }
    void print(std::string_view) override {}
    void explain_calls(Diagnostic&) override {}
    const scene::Scene& scene() const override { return scene_; }
    const Symbols& symbols() const override { return symbols_; }
    Symbol intern(std::string_view) override { return kNoSymbol; }

 private:
    // Items
    void items(std::span<Item* const> list, OpenBlock& open);
    void property(const PropertyItem& item, OpenBlock& open);
    void common_property(CommonProperty property, const Value& value, const Expr& expr,
                         OpenBlock& open);
    void step(CommonProperty step, const Value& value, const Expr& expr, OpenBlock& open);
    void placed_block(const BlockItem& item, OpenBlock& open);

    // Blocks
    struct Head {
        const BlockSchema* schema = nullptr;  // null: not a block; reported or poisoned
        const Made* made = nullptr;           // of a value
    };
    Head head(const BlockExpr& expr, bool is_placed);
    Value block_value(const BlockExpr& expr);
    void view_block(const BlockSchema& schema, const BlockExpr& expr);
    std::optional<scene::NodeId> instance(const BlockExpr& expr, const Made& made);
    Value make_material(const OpenBlock& open);
    Value make_texture(const OpenBlock& open);
    std::optional<scene::NodeId> make_node(const OpenBlock& open, const StringExpr* label);
    std::optional<ShapeRef> shape_of(const OpenBlock& open);
    scene::NodeId add_node(const OpenBlock& open, scene::NodeKind kind, std::size_t index,
                           const StringExpr* label);

    // Expressions
    Value eval(const Expr& expr);
    Value name(const NameExpr& expr);
    Value unary(const UnaryExpr& expr);
    Value binary(const BinaryExpr& expr);
    Value logical(const BinaryExpr& expr);
    Value conditional(const ConditionalExpr& expr);
    Value call(const CallExpr& expr);
    Value index(const IndexExpr& expr);
    Value member(const MemberExpr& expr);
    Value material_member(const MemberExpr& expr, const Made& made);
    Value node_member(const MemberExpr& expr, const Made& made);
    Value list(const ListExpr& expr);
    std::optional<bool> condition(const Expr& expr);
    void explain_zero(const Expr& divisor, Diagnostic& diagnostic);

    Diagnostic& error(Code code, Span span, std::string message) {
        return diagnostics_.error(code, span, std::move(message));
    }
    std::string_view text(const Expr& expr) const { return sources_.text(expr.span); }

    const Checked& checked_;
    const Symbols& symbols_;
    const Sources& sources_;
    FileLoader& files_;
    Arena arena_;
    Budget budget_;
    scene::Scene& scene_;
    Diagnostics& diagnostics_;
    std::vector<Value> variables_;
};

}  // namespace lray::parser
