// The evaluator's state: frames, what a block gathers while it runs, and the passes over items,
// blocks and expressions. Used by evaluator_*.cpp alone.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "parser/arena.h"
#include "parser/blocks/build_shape.h"
#include "parser/blocks/property_values.h"
#include "parser/builtins/builtins.h"
#include "parser/evaluate/evaluator.h"
#include "parser/evaluate/open_record.h"
#include "parser/evaluate/regions.h"
#include "parser/values/operators.h"

namespace lray::parser {

/// A block while its items are evaluated.
struct OpenBlock {
    explicit OpenBlock(const BlockSchema& block_schema, Span block_span)
        : schema(block_schema), span(block_span), values(block_schema.properties) {}

    const BlockSchema& schema;
    Span span{};
    PropertyValues values;
    std::array<Span, kMaxProperties> value_spans{};  // of those that are set between its braces
    std::array<Span, 3> common_spans{};              // of `material` and what follows it
    std::vector<scene::NodeId> children{};
    OpenRecord record{};
    Transform transform{};
    bool has_steps = false;
    std::optional<scene::MaterialId> material_id{};
    bool visible = true;
    bool casts_shadow = true;
    bool is_poisoned = false;  // a property could not be evaluated: nothing is made
    bool is_import = false;    // the outermost items of an imported file: nothing is placed

    // For W1301: the last `scale` behind a `translate` and before any other one.
    bool has_translated = false;
    Span scale_after_translate{};
};

/// How much of a value a message shows.
inline constexpr std::size_t kShownBytes = 80;

/// How the items of a body ended.
enum class Flow : std::uint8_t { normal, break_loop, continue_loop, return_value };

class Evaluator final : public Runtime {
 public:
    Evaluator(const Environment& environment, scene::Scene& scene, Diagnostics& diagnostics,
              const char* stack_end);

    void run(std::span<Item* const> items);

    // Runtime
    Value call_function(const Value& function, std::span<const Value> arguments,
                        Span span) override;
    void print(std::string_view line, Span span) override;
    const scene::Scene& scene() const override { return scene_; }
    const Symbols& symbols() const override { return symbols_; }
    Symbol intern(std::string_view name) override { return environment_.symbols.intern(name); }

 private:
    // Items
    Flow items(std::span<Item* const> list, OpenBlock& open);
    Flow item(Item& item, OpenBlock& open);
    void let(const LetItem& item);
    Value param(const LetItem& item);
    void list_param(const LetItem& item, const Value& value, const Value& fallback,
                    const Value& choices);
    std::string needs_type(const LetItem& item, const Value& value) const;
    struct Misfit {
        Code code{};
        Span span{};
        std::string message{};
    };
    std::optional<Misfit> misfit_of(const LetItem& item, const Value& value, const Value& fallback,
                                    const Value& choices);
    void assign(const AssignmentItem& item);
    void import(const ImportItem& item);
    Flow for_loop(ForItem& item, OpenBlock& open);
    Flow while_loop(WhileItem& item, OpenBlock& open);
    struct LoopMemory {
        Region region{};         // since the loop began
        std::size_t in_use = 0;  // bytes that its variables held when they were copied last
    };
    Flow time_round(const Body& body, const LoopInfo& loop, LoopMemory& memory, OpenBlock& open);
    void end_round(const LoopInfo& loop, LoopMemory& memory);
    void literals(const LiteralsItem& item, OpenBlock& open);
    bool give_material(const LiteralsItem& item);
    std::optional<scene::MaterialId> material_of_literals(const NameExpr& name);
    Value* variable(const SlotRef& slot) {
        return slot.is_global ? &globals_[slot.slot] : &frame_[slot.slot];
    }

    // Properties
    void property(PropertyItem& item, OpenBlock& open);
    void free_field(const PropertyItem& item, const Value& value, OpenBlock& open);
    bool set_once(Span& first, const PropertyItem& item);
    void common_property(CommonProperty property, const Value& value, const PropertyItem& item,
                         OpenBlock& open);
    void step(CommonProperty step, const Value& value, const Expr& expr, OpenBlock& open);

    // Blocks
    struct Head {
        const BlockSchema* schema = nullptr;  // null: not a block; reported or poisoned
        const Made* made = nullptr;           // of a value
        const FunctionUse* component = nullptr;
        Value record{};  // that is copied
    };
    Head head(BlockExpr& expr, bool is_placed);
    void placed_block(BlockExpr& expr, OpenBlock& open);
    Value block_value(BlockExpr& expr);
    void start_copy(const Made& made, OpenBlock& open);
    bool body(const BlockExpr& expr, OpenBlock& open, bool is_new = true);
    const Value* keep_all(std::span<const Value> values, Span span);
    void view_block(const BlockSchema& schema, BlockExpr& expr);
    void file_view(const FileViewItem& item);
    std::optional<scene::NodeId> instance(const BlockExpr& expr, const Made& made);
    std::optional<scene::MaterialId> add_material(const OpenBlock& open);
    scene::MaterialId own_material_of(const scene::MeshUse& use);
    std::optional<scene::TextureId> add_texture(const OpenBlock& open);
    Value record_value(const OpenBlock& open);
    Value made_value(ValueKind kind, const OpenBlock& open, std::uint32_t id);
    std::optional<scene::NodeId> make_node(const OpenBlock& open, const StringExpr* label);
    std::optional<ShapeRef> shape_of(const OpenBlock& open);
    scene::NodeId add_node(const OpenBlock& open, scene::NodeKind kind, std::size_t index,
                           const StringExpr* label);

    // Components
    std::optional<scene::NodeId> place_component(const BlockExpr& expr, const FunctionUse& use);
    std::optional<scene::NodeId> make_component(const OpenBlock& open,
                                                const FunctionValue& component,
                                                scene::NodeId children, const StringExpr* label);
    FunctionValue captured(const FunctionUse& use);
    scene::NodeId children_of(const OpenBlock& open);
    std::optional<scene::NodeId> instantiate(const FunctionValue& component,
                                             std::span<const Value> parameters,
                                             scene::NodeId children, Span span);
    scene::NodeId add_group(const std::vector<scene::NodeId>& children, Span span);
    scene::NodeId push_node(const scene::Node& node);
    void too_many_nodes(Span span);
    Value node_value(scene::NodeId id);

    // Calls
    Value call(const CallExpr& expr);
    Value call_builtin_function(const CallExpr& expr, const Builtin& builtin);
    Value call_use(const CallExpr& expr, const FunctionUse& use);
    Value call_value(const CallExpr& expr, const Value& callee);
    Value assertion(const CallExpr& expr);
    bool has_room(const Function& function, Span span);
    std::size_t push_frame(const Function& function);
    void enter(const Function& function, std::size_t base, Span span);
    void leave();
    bool complete_parameters(const Function& function, Span span);
    Value result_of(const Function& function, Span span);

    // Expressions
    Value eval(const Expr& expr);
    Value name(const NameExpr& expr);
    Value no_value_yet(const NameExpr& expr);
    Value function_value(const FunctionUse& use);
    Value unary(const UnaryExpr& expr);
    Value binary(const BinaryExpr& expr);
    Value binary_slow(const BinaryExpr& expr, const Value& left, const Value& right);
    Value logical(const BinaryExpr& expr);
    Value conditional(const ConditionalExpr& expr);
    Value index(const IndexExpr& expr);
    Value member(const MemberExpr& expr);
    Value material_member(const MemberExpr& expr, const Made& made);
    Value node_member(const MemberExpr& expr, const Made& made);
    Value record_member(const MemberExpr& expr, const Value& record);
    Value list(const ListExpr& expr);
    Value packed_list(const PackedListExpr& expr);
    Value list_of(std::span<const Value> elements, Span span);
    Value comprehension(const ComprehensionExpr& expr);
    std::optional<bool> condition(const Expr& expr);
    void explain_zero(const Expr& divisor, Diagnostic& diagnostic);

    /// The elements that a loop goes through: a list, or a range that is never made.
    struct Sequence {
        Value list{};
        double start = 0.0;
        double step = 1.0;
        std::uint64_t count = 0;
        bool is_range = false;

        Value at(std::uint64_t i) const {
            return is_range ? Value::of(start + static_cast<double>(i) * step)
                            : element(list, static_cast<std::uint32_t>(i));
        }
    };
    std::optional<Sequence> sequence(const Expr& expr);
    std::optional<Sequence> range_of(const CallExpr& call);

    void explain_calls(Diagnostic& diagnostic);
    Diagnostic& error(Code code, Span span, std::string message) {
        return diagnostics_.error(code, span, std::move(message));
    }
    /// Takes a step for every few of what is gone through without one of its own.
    bool take_share(std::size_t count, Span span) {
        constexpr std::size_t kFew = 16;
        return count < kFew || take_steps(budget_, count / kFew, span, diagnostics_);
    }
    Value failed(Code code, Span span, std::string message) {
        error(code, span, std::move(message));
        return Value::poison();
    }
    std::string_view text(const Expr& expr) const { return sources_.text(expr.span); }
    Arena& arena() { return memory_.arena(); }

    const Environment& environment_;
    const Checked& checked_;
    const Symbols& symbols_;
    const Sources& sources_;
    FileLoader& files_;
    Budget budget_;
    ValueMemory memory_;
    scene::Scene& scene_;
    std::optional<scene::MaterialId> vertex_colors_{};  // of all meshes that have no other
    Diagnostics& diagnostics_;

    std::unordered_map<const LetItem*, const Param*> params_of_items_;  // once one is listed
    std::vector<Value> globals_;
    std::vector<Value> slots_;    // the frames of all calls, one behind the other
    Value* frame_ = nullptr;      // of the call at hand, in `slots_`
    std::size_t base_ = 0;        // where it begins
    std::size_t top_ = 0;         // where the next one begins
    Value result_{};              // of `return`
    std::uint64_t failures_ = 0;  // items that could not be done; a loop or function ends with one

    struct ActiveCall {
        const Function* function = nullptr;
        Span span{};
        std::size_t base = 0;  // of the frame it left
    };
    std::vector<ActiveCall> calls_;
    std::vector<bool> is_imported_;                              // by Module::id
    std::unordered_map<std::string, scene::NodeId> components_;  // none: it could not be made
    Value nothing_{};          // an empty group, once there is one
    bool has_render_ = false;  // a `render` block was evaluated
    std::uint64_t printed_bytes_ = 0;
    std::uint32_t range_builtin_ = 0;
    std::uint32_t assert_builtin_ = 0;
    const char* stack_end_ = nullptr;  // the evaluator does not go below
};

}  // namespace lray::parser
