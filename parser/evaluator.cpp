#include "parser/evaluator.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "parser/build_material.h"
#include "parser/build_mesh.h"
#include "parser/build_shape.h"
#include "parser/build_view.h"
#include "parser/builtins.h"
#include "parser/check_block.h"
#include "parser/constant_value.h"
#include "parser/operators.h"
#include "parser/prelude.h"
#include "parser/property_type.h"
#include "parser/schemas.h"
#include "parser/transform_values.h"

namespace lray::parser {

namespace {

using scene::NodeId;

/// A block while its items are evaluated.
struct OpenBlock {
    explicit OpenBlock(const BlockSchema& block_schema, Span block_span)
        : schema(block_schema), span(block_span), values(block_schema.properties) {}

    const BlockSchema& schema;
    Span span{};
    PropertyValues values;
    std::array<Span, kMaxProperties> value_spans{};
    std::vector<NodeId> children{};
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

class Evaluator {
 public:
    Evaluator(const Checked& checked, const Symbols& symbols, const Sources& sources,
              FileLoader& files, const LoadLimits& limits, scene::Scene& scene,
              Diagnostics& diagnostics)
        : checked_(checked),
          symbols_(symbols),
          sources_(sources),
          files_(files),
          budget_{limits.steps, limits.value_bytes, limits.steps, limits.value_bytes, false},
          scene_(scene),
          diagnostics_(diagnostics),
          variables_(checked.variables.size(), Value::poison()) {}

    void run(std::span<Item* const> items);

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
    std::optional<NodeId> instance(const BlockExpr& expr, const Made& made);
    Value make_material(const OpenBlock& open);
    std::optional<NodeId> make_node(const OpenBlock& open, const StringExpr* label);
    std::optional<ShapeRef> shape_of(const OpenBlock& open);
    NodeId add_node(const OpenBlock& open, scene::NodeKind kind, std::size_t index,
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

// ---- items

void Evaluator::run(std::span<Item* const> list) {
    OpenBlock root(block_schema(BlockKind::group), Span{});
    items(list, root);
    scene_.root = add_node(root, scene::NodeKind::group, scene_.groups.size(), nullptr);
    scene_.groups.push_back({std::move(root.children)});
}

void Evaluator::items(std::span<Item* const> list, OpenBlock& open) {
    for (const Item* item : list) {
        switch (item->kind) {
            case ItemKind::let: {
                const LetItem& let = static_cast<const LetItem&>(*item);
                variables_[let.slot] = eval(*let.value);
                break;
            }
            case ItemKind::property:
                property(static_cast<const PropertyItem&>(*item), open);
                break;
            case ItemKind::block:
                placed_block(static_cast<const BlockItem&>(*item), open);
                break;
            case ItemKind::literals: {
                const LiteralsItem& literals = static_cast<const LiteralsItem&>(*item);
                for (std::uint32_t i = 0; i < literals.count; ++i) {
                    open.children.push_back(NodeId(literals.first_node + i));
                }
                break;
            }
            case ItemKind::include:
                items(static_cast<const IncludeItem&>(*item).items, open);
                break;
            case ItemKind::call:
            case ItemKind::assignment:
                break;  // errors, reported by the checker
        }
    }
}

void Evaluator::property(const PropertyItem& item, OpenBlock& open) {
    const Value value = eval(*item.value);
    if (open.schema.takes_any_string) {
        if (value.is(ValueKind::string)) {
            if (!take_bytes(budget_, value.count, item.value->span, diagnostics_)) return;
            scene_.info.emplace_back(symbols_.text(item.name), value.string());
        } else if (!value.is(ValueKind::poison)) {
            error(Code::E0301, item.value->span,
                  fmt::format("`{}` needs a string, this is {}", symbols_.text(item.name),
                              describe(value)));
        }
        return;
    }
    const PropertyPlace place = find_place(open.schema, symbols_.text(item.name));
    LRAY_ASSERT(place.schema != nullptr);
    const Value fitted =
        fit(*place.schema, value, item.value->span, diagnostics_, name_of(*item.value, sources_));
    if (fitted.is(ValueKind::poison)) {
        open.is_poisoned = true;
    } else if (place.is_common) {
        common_property(static_cast<CommonProperty>(place.slot), fitted, *item.value, open);
    } else {
        open.values.set(place.slot, fitted);
        open.value_spans[place.slot] = item.value->span;
    }
}

void Evaluator::common_property(CommonProperty property, const Value& value, const Expr& expr,
                                OpenBlock& open) {
    if (property == CommonProperty::material) {
        open.material_id = scene::MaterialId(value.made->id);
    } else if (property == CommonProperty::visible) {
        open.visible = value.boolean;
    } else if (property == CommonProperty::casts_shadow) {
        open.casts_shadow = value.boolean;
    } else {
        step(property, value, expr, open);
    }
}

/// True if degrees look like a familiar angle in radians: a multiple of pi / 12, written to at
/// least three decimals, or computed.
bool looks_like_radians(double angle, const Expr& expr) {
    if (expr.kind == ExprKind::number && static_cast<const NumberExpr&>(expr).has_unit) {
        return false;
    }
    const double steps = angle * (12.0 / std::numbers::pi);
    const double nearest = std::round(steps);
    const bool is_literal = expr.kind == ExprKind::number || expr.kind == ExprKind::unary;
    // 3.14 to 3.14159...: a literal is cut short, a computed one is as exact as a double.
    const double tolerance = is_literal ? 6e-4 : 1e-12;
    return nearest != 0.0 && std::fabs(nearest) <= 24.0 &&
           std::fabs(steps - nearest) <= tolerance * std::fabs(nearest) &&
           angle != std::round(angle);
}

void Evaluator::step(CommonProperty step, const Value& value, const Expr& expr, OpenBlock& open) {
    const bool is_turn = step == CommonProperty::rotate_x || step == CommonProperty::rotate_y ||
                         step == CommonProperty::rotate_z;
    if (is_turn && looks_like_radians(value.number, expr)) {
        const double meant = std::round(value.number * (12.0 / std::numbers::pi)) * 15.0;
        diagnostics_.warning(Code::W1302, expr.span,
                             fmt::format("angles are degrees; did you mean `{}` or `{}rad`?",
                                         format_number(meant), format_number(value.number)));
    }
    if (step == CommonProperty::translate && value.vec3() != DVec3{0.0}) {
        open.has_translated = true;
        open.scale_after_translate = Span{};
    } else if (step == CommonProperty::scale && open.has_translated) {
        open.scale_after_translate = expr.span;
    }
    open.transform = with_step(open.transform, step, value);
    open.has_steps = true;
    if (!open.transform.is_finite()) {
        error(Code::E0310, expr.span, "this step makes the transform larger than numbers go");
        open.is_poisoned = true;
    } else if (!open.transform.inverse()) {
        error(Code::E0310, expr.span, "this transform cannot be inverted: it flattens the object");
        open.is_poisoned = true;
    }
}

void Evaluator::placed_block(const BlockItem& item, OpenBlock& open) {
    const BlockExpr& expr = *item.block;
    const Head made_of = head(expr, true);
    if (made_of.schema == nullptr) return;
    if (made_of.schema->kind == BlockKind::material) {  // inline: `sphere { material { } }`
        const Value value = block_value(expr);
        if (value.is(ValueKind::material)) {
            open.material_id = scene::MaterialId(value.made->id);
        } else {
            open.is_poisoned = true;
        }
        return;
    }
    if (!made_of.schema->is_placeable) {
        view_block(*made_of.schema, expr);
        return;
    }
    std::optional<NodeId> child;
    if (made_of.made != nullptr) {
        child = instance(expr, *made_of.made);
    } else {
        OpenBlock inner(*made_of.schema, expr.span);
        items(expr.body.items, inner);
        child = make_node(inner, expr.label);
    }
    if (child) open.children.push_back(*child);
}

// ---- blocks

Evaluator::Head Evaluator::head(const BlockExpr& expr, bool is_placed) {
    if (expr.head->kind == ExprKind::name) {
        const NameExpr& built_in = static_cast<const NameExpr&>(*expr.head);
        if (built_in.meaning == Meaning::block) {
            return {&block_schema(static_cast<BlockKind>(built_in.index)), nullptr};
        }
    }
    const Value value = eval(*expr.head);
    if (value.is(ValueKind::poison)) return {};
    const bool is_material = value.is(ValueKind::material);
    if (!is_material && !value.is(ValueKind::node)) {
        error(
            Code::E0408, expr.head->span,
            fmt::format("`{}` is {}; only blocks take braces", text(*expr.head), describe(value)));
        return {};
    }
    if (is_material && is_placed) {
        error(Code::E0408, expr.head->span, "a material cannot be placed")
            .with_hint(fmt::format("use `material: {}` in a shape", text(*expr.head)));
        return {};
    }
    const BlockSchema& schema = *value.made->schema;
    // A head whose type the checker could not tell is checked now; otherwise again, in silence.
    const BlockUse use = is_placed ? BlockUse::instance : BlockUse::copy;
    Diagnostics again;
    if (!check_block(schema, expr, use, symbols_, sources_, again)) {
        diagnostics_.append(again);
        return {};
    }
    return {&schema, value.made};
}

// A block in the place of a value: a material, or a node that is not placed.
Value Evaluator::block_value(const BlockExpr& expr) {
    const Head made_of = head(expr, false);
    if (made_of.schema == nullptr) return Value::poison();
    const BlockSchema& schema = *made_of.schema;
    const bool is_material = schema.kind == BlockKind::material;
    if (!is_material && !schema.is_placeable) {
        error(Code::E0408, expr.head->span, fmt::format("a `{}` block is not a value", schema.name))
            .with_help("write it at the top level");
        return Value::poison();
    }
    OpenBlock open(schema, expr.span);
    if (made_of.made != nullptr) {
        open.values = *made_of.made->values;
        if (!is_material) {
            const scene::Node& original = scene_.nodes[made_of.made->id];
            if (!original.transform_id.is_none()) {
                open.transform = scene_.transforms[original.transform_id.index()];
                open.has_steps = true;
            }
            if (!original.material_id.is_none()) open.material_id = original.material_id;
            open.visible = original.visible;
            open.casts_shadow = original.casts_shadow;
            if (original.kind == scene::NodeKind::group) {
                const std::vector<NodeId>& children = scene_.groups[original.index].children;
                const std::uint64_t size = children.size() * sizeof(NodeId);
                if (!take_bytes(budget_, size, expr.span, diagnostics_)) return Value::poison();
                open.children = children;
            }
        }
    }
    items(expr.body.items, open);
    if (is_material) return make_material(open);
    const std::optional<NodeId> node = make_node(open, expr.label);
    if (!node) return Value::poison();
    const PropertyValues* values = arena_.make<PropertyValues>(open.values);
    return Value::of_made(ValueKind::node, arena_.make<Made>(&schema, values, node->value));
}

Value Evaluator::make_material(const OpenBlock& open) {
    if (open.is_poisoned) return Value::poison();
    const scene::MaterialId id(scene_.materials.size());
    scene_.materials.push_back(build_material(open.values, open.span, diagnostics_));
    const PropertyValues* values = arena_.make<PropertyValues>(open.values);
    return Value::of_made(ValueKind::material, arena_.make<Made>(&open.schema, values, id.value));
}

void Evaluator::view_block(const BlockSchema& schema, const BlockExpr& expr) {
    OpenBlock open(schema, expr.span);
    items(expr.body.items, open);
    if (open.is_poisoned) return;
    if (schema.kind == BlockKind::camera) {
        const std::string_view name =
            expr.label != nullptr ? expr.label->value : std::string_view{};
        if (auto camera = build_camera(open.values, name, expr.head->span, diagnostics_)) {
            scene_.cameras.push_back(std::move(*camera));
        }
    } else if (schema.kind == BlockKind::render) {
        scene_.render = build_render_settings(open.values);
    }
}

// A node value placed: the node once more, under the steps and material written here.
std::optional<NodeId> Evaluator::instance(const BlockExpr& expr, const Made& made) {
    OpenBlock open(*made.schema, expr.span);
    items(expr.body.items, open);
    if (open.is_poisoned) return std::nullopt;
    const NodeId id =
        add_node(open, scene::NodeKind::instance, scene_.instances.size(), expr.label);
    scene_.instances.push_back({NodeId(made.id)});
    return id;
}

std::optional<NodeId> Evaluator::make_node(const OpenBlock& open, const StringExpr* label) {
    if (open.is_poisoned) return std::nullopt;
    if (!open.scale_after_translate.is_nowhere()) {
        diagnostics_
            .warning(Code::W1301, open.scale_after_translate,
                     "`scale` after `translate` also multiplies the way it was moved")
            .with_help("scale first, or write the steps as `transform: [...]`");
    }
    const std::optional<ShapeRef> shape = shape_of(open);
    if (!shape) return std::nullopt;
    return add_node(open, shape->kind, shape->index, label);
}

std::optional<ShapeRef> Evaluator::shape_of(const OpenBlock& open) {
    if (open.schema.kind == BlockKind::group) {
        scene_.groups.push_back({open.children});
        return ShapeRef{scene::NodeKind::group,
                        static_cast<std::uint32_t>(scene_.groups.size() - 1)};
    }
    if (open.schema.kind == BlockKind::mesh) {
        std::uint64_t numbers = 0;  // a list may be used for any number of meshes
        for (std::size_t slot = 0; slot < open.schema.properties.size(); ++slot) {
            const Value& value = open.values[slot];
            if (value.is(ValueKind::rows)) numbers += std::uint64_t{value.count} * value.width;
        }
        const std::uint64_t size = numbers * sizeof(float);
        if (!take_bytes(budget_, size, open.span, diagnostics_)) return std::nullopt;
        const std::optional<scene::MeshUse> use =
            build_mesh(open.values, open.value_spans, open.span, files_, scene_, diagnostics_);
        if (!use) return std::nullopt;
        scene_.mesh_uses.push_back(*use);
        return ShapeRef{scene::NodeKind::mesh,
                        static_cast<std::uint32_t>(scene_.mesh_uses.size() - 1)};
    }
    return build_shape(open.schema, open.values, open.span, scene_, diagnostics_);
}

NodeId Evaluator::add_node(const OpenBlock& open, scene::NodeKind kind, std::size_t index,
                           const StringExpr* label) {
    scene::Node node;
    node.kind = kind;
    node.visible = open.visible;
    node.casts_shadow = open.casts_shadow;
    node.index = static_cast<std::uint32_t>(index);
    node.span = open.span;
    if (open.has_steps) {
        node.transform_id = scene::TransformId(scene_.transforms.size());
        scene_.transforms.push_back(open.transform);
    }
    if (open.material_id) node.material_id = *open.material_id;
    if (label != nullptr) {
        node.label_id = scene::LabelId(scene_.labels.size());
        scene_.labels.emplace_back(label->value);
    }
    const NodeId id(scene_.nodes.size());
    scene_.nodes.push_back(node);
    return id;
}

// ---- expressions

Value Evaluator::eval(const Expr& expr) {
    if (!take_steps(budget_, 1, expr.span, diagnostics_)) return Value::poison();
    switch (expr.kind) {
        case ExprKind::error:
            return Value::poison();
        case ExprKind::number:
        case ExprKind::boolean:
        case ExprKind::string:
        case ExprKind::color:
        case ExprKind::packed_list:
            return *constant_value(expr, arena_);
        case ExprKind::name:
            return name(static_cast<const NameExpr&>(expr));
        case ExprKind::unary:
            return unary(static_cast<const UnaryExpr&>(expr));
        case ExprKind::binary:
            return binary(static_cast<const BinaryExpr&>(expr));
        case ExprKind::conditional:
            return conditional(static_cast<const ConditionalExpr&>(expr));
        case ExprKind::call:
            return call(static_cast<const CallExpr&>(expr));
        case ExprKind::index:
            return index(static_cast<const IndexExpr&>(expr));
        case ExprKind::member:
            return member(static_cast<const MemberExpr&>(expr));
        case ExprKind::list:
            return list(static_cast<const ListExpr&>(expr));
        case ExprKind::block:
            return block_value(static_cast<const BlockExpr&>(expr));
    }
    LRAY_ASSERT(false);
}

Value Evaluator::name(const NameExpr& expr) {
    switch (expr.meaning) {
        case Meaning::variable:
            return variables_[expr.index];
        case Meaning::constant:
            return prelude_constants()[expr.index].value;
        case Meaning::function:
            error(Code::E0301, expr.span,
                  fmt::format("`{0}` is a function; call it: `{0}(...)`", text(expr)));
            return Value::poison();
        case Meaning::colors:
            error(Code::E0301, expr.span, "`colors` needs a name: `colors.red`");
            return Value::poison();
        case Meaning::block:
        case Meaning::unknown:
            return Value::poison();
    }
    LRAY_ASSERT(false);
}

Value Evaluator::unary(const UnaryExpr& expr) {
    if (expr.op == TokenKind::kw_not) {
        const std::optional<bool> operand = condition(*expr.operand);
        return operand ? Value::of(!*operand) : Value::poison();
    }
    return apply_sign(expr.op, eval(*expr.operand), expr.span, arena_, budget_, diagnostics_);
}

Value Evaluator::binary(const BinaryExpr& expr) {
    if (is_one_of(expr.op, TokenKind::kw_and, TokenKind::kw_or)) return logical(expr);
    const Value left = eval(*expr.left);
    const Value right = eval(*expr.right);
    const bool is_division = is_one_of(expr.op, TokenKind::slash, TokenKind::percent);
    const bool is_zero = is_division && right.is(ValueKind::number) && right.number == 0.0;
    if (is_zero && !left.is(ValueKind::poison)) {
        Diagnostic& diagnostic = error(Code::E0503, expr.op_span, "division by zero");
        explain_zero(*expr.right, diagnostic);
        return Value::poison();
    }
    return apply(expr.op, left, right, expr.op_span, arena_, budget_, diagnostics_);
}

// "`n` is 0, defined here"
void Evaluator::explain_zero(const Expr& divisor, Diagnostic& diagnostic) {
    if (divisor.kind != ExprKind::name) return;
    const NameExpr& variable = static_cast<const NameExpr&>(divisor);
    if (variable.meaning != Meaning::variable) return;
    diagnostic.with_label(checked_.variables[variable.index],
                          fmt::format("`{}` is 0, defined here", text(divisor)));
}

std::optional<bool> Evaluator::condition(const Expr& expr) {
    const Value value = eval(expr);
    if (value.is(ValueKind::boolean)) return value.boolean;
    if (!value.is(ValueKind::poison)) {
        error(Code::E0301, expr.span,
              fmt::format("a condition is true or false, this is {}", describe(value)))
            .with_help("compare it: `a > 0`, `a == b`");
    }
    return std::nullopt;
}

Value Evaluator::logical(const BinaryExpr& expr) {
    const std::optional<bool> left = condition(*expr.left);
    if (!left) return Value::poison();
    const bool decides = expr.op == TokenKind::kw_or;
    if (*left == decides) return Value::of(decides);
    const std::optional<bool> right = condition(*expr.right);
    return right ? Value::of(*right) : Value::poison();
}

Value Evaluator::conditional(const ConditionalExpr& expr) {
    const std::optional<bool> chosen = condition(*expr.condition);
    if (!chosen) return Value::poison();
    return eval(*chosen ? *expr.then_value : *expr.else_value);
}

Value Evaluator::call(const CallExpr& expr) {
    LRAY_ASSERT(expr.callee->kind == ExprKind::name);
    const NameExpr& callee = static_cast<const NameExpr&>(*expr.callee);
    if (callee.meaning != Meaning::function) return Value::poison();
    const Builtin& builtin = builtins()[callee.index];
    Call made{{}, expr.arguments.size(), expr.span, arena_, budget_, diagnostics_};
    std::array<Span, kMaxParameters> spans{};
    std::size_t position = 0;
    for (const Argument& argument : expr.arguments) {
        std::size_t place = position++;
        if (argument.name != kNoSymbol) {
            place = 0;
            while (builtin.parameters[place].name != symbols_.text(argument.name)) ++place;
        }
        made.arguments[place] = eval(*argument.value);
        spans[place] = argument.value->span;
    }
    return call_builtin(builtin, made, spans);
}

Value Evaluator::index(const IndexExpr& expr) {
    const Value object = eval(*expr.object);
    const Value at = eval(*expr.index);
    if (object.is(ValueKind::poison) || at.is(ValueKind::poison)) return Value::poison();
    if (!object.is_list()) {
        error(Code::E0301, expr.object->span,
              fmt::format("only lists have elements, `{}` is {}", text(*expr.object),
                          describe(object)));
        return Value::poison();
    }
    if (!at.is(ValueKind::number)) {
        error(Code::E0301, expr.index->span,
              fmt::format("an index is a number, this is {}", describe(at)));
        return Value::poison();
    }
    if (at.number != std::floor(at.number)) {
        error(Code::E0308, expr.index->span,
              fmt::format("an index is a whole number, this is {}", format_number(at.number)));
        return Value::poison();
    }
    if (at.number < 0.0 || at.number >= object.count) {
        const std::string has =
            object.count == 0 ? "is empty" : fmt::format("has elements 0 to {}", object.count - 1);
        error(Code::E0504, expr.index->span,
              fmt::format("index {}, but `{}` {}", format_number(at.number), text(*expr.object),
                          has));
        return Value::poison();
    }
    return element(object, static_cast<std::uint32_t>(at.number));
}

Value Evaluator::member(const MemberExpr& expr) {
    const std::string_view field = symbols_.text(expr.name);
    if (expr.object->kind == ExprKind::name &&
        static_cast<const NameExpr&>(*expr.object).meaning == Meaning::colors) {
        const std::optional<std::uint32_t> constant = find_constant(field);
        if (constant && prelude_constants()[*constant].value.is(ValueKind::color)) {
            return prelude_constants()[*constant].value;
        }
        error(Code::E0409, expr.name_span, fmt::format("there is no colour `{}`", field));
        return Value::poison();
    }
    const Value object = eval(*expr.object);
    if (object.is(ValueKind::poison)) return object;
    if (object.is(ValueKind::material)) return material_member(expr, *object.made);
    if (object.is(ValueKind::node)) return node_member(expr, *object.made);
    constexpr std::string_view kAxes = "xyzw";
    constexpr std::string_view kChannels = "rgba";
    const bool is_vector = object.is(ValueKind::numbers) && object.count >= 2 && object.count <= 4;
    const bool is_color = object.is(ValueKind::color);
    const std::size_t component = is_color ? kChannels.find(field) : kAxes.find(field);
    const bool has_it = field.size() == 1 && component != std::string_view::npos &&
                        component < object.count && (is_vector || is_color);
    if (has_it) return Value::of(object.numbers[component]);
    Diagnostic& diagnostic = error(Code::E0409, expr.name_span,
                                   fmt::format("{} has no field `{}`", describe(object), field));
    if (is_vector) {
        diagnostic.with_help("a vector has x, y, z and w, as far as it goes");
    } else if (is_color) {
        diagnostic.with_help("a colour has r, g, b and a");
    }
    return Value::poison();
}

Value Evaluator::material_member(const MemberExpr& expr, const Made& made) {
    const std::string_view field = symbols_.text(expr.name);
    const std::size_t slot = find_property(made.schema->properties, field);
    if (slot == made.schema->properties.size()) {
        error(Code::E0409, expr.name_span, fmt::format("a material has no field `{}`", field));
        return Value::poison();
    }
    const Value& value = (*made.values)[slot];
    if (!value.is(ValueKind::none)) return value;
    const scene::Material& material = scene_.materials[made.id];
    const PropertySchema& property = made.schema->properties[slot];
    const auto color = [&](const Color& linear) {
        const std::array<double, 4> rgba = {linear.x, linear.y, linear.z, 1.0};
        return Value::of_color(arena_.copy(std::span<const double>(rgba)).data());
    };
    using namespace schemas;
    if (property.type == PropertyType::boolean) return Value::of(property.default_value[0] != 0.0);
    if (property.type == PropertyType::option) return Value::of_string("blinn_phong", kNoSource);
    if (slot == schemas::slot(kMaterial, "ambient")) {
        return color(material.ambient.value_or(material.diffuse));
    }
    if (slot == schemas::slot(kMaterial, "specular")) {
        const bool is_microfacet = material.model == scene::ReflectionModel::cook_torrance ||
                                   material.model == scene::ReflectionModel::ward;
        return color(material.specular.value_or(Color{is_microfacet ? 1.0f : 0.2f}));
    }
    if (property.type == PropertyType::color) {
        return color(Color{made.values->color(slot)});
    }
    return Value::of(property.default_value[0]);
}

// A property of a shape: as it was set, or its default.
Value Evaluator::node_member(const MemberExpr& expr, const Made& made) {
    const std::string_view field = symbols_.text(expr.name);
    const std::span<const PropertySchema> properties = made.schema->properties;
    const std::size_t slot = find_property(properties, field);
    if (slot == properties.size()) {
        error(Code::E0409, expr.name_span,
              fmt::format("a {} has no field `{}`", made.schema->name, field));
        return Value::poison();
    }
    const Value& value = (*made.values)[slot];
    if (!value.is(ValueKind::none)) return value;
    const PropertySchema& property = properties[slot];
    const std::span<const double> fallback = property.default_value;
    if (property.default_text.starts_with('[')) {
        const bool is_plane = property.type == PropertyType::size2;
        return Value::of_numbers(fallback.first(is_plane ? 2 : 3));
    }
    if (property.type == PropertyType::boolean) return Value::of(fallback[0] != 0.0);
    if (property.type == PropertyType::number && !property.default_text.empty()) {
        return Value::of(fallback[0]);
    }
    error(Code::E0409, expr.name_span,
          fmt::format("`{}` is not set in this {}", field, made.schema->name));
    return Value::poison();
}

Value Evaluator::list(const ListExpr& expr) {
    const std::uint64_t size = expr.elements.size() * sizeof(Value);
    if (!take_bytes(budget_, size, expr.span, diagnostics_)) return Value::poison();
    std::vector<Value> elements;
    elements.reserve(expr.elements.size());
    for (const Expr* element_expr : expr.elements) elements.push_back(eval(*element_expr));
    return make_list(elements, arena_);
}

}  // namespace

void evaluate(std::span<Item* const> items, const Checked& checked, const Symbols& symbols,
              const Sources& sources, FileLoader& files, const LoadLimits& limits,
              scene::Scene& scene, Diagnostics& diagnostics) {
    Evaluator(checked, symbols, sources, files, limits, scene, diagnostics).run(items);
}

}  // namespace lray::parser
