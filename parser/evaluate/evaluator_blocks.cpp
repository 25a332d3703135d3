// Evaluates blocks: materials, shapes, groups, meshes, instances, views.
#include <fmt/format.h>

#include <utility>

#include "base/assert.h"
#include "parser/blocks/build_light.h"
#include "parser/blocks/build_material.h"
#include "parser/blocks/build_mesh.h"
#include "parser/blocks/build_texture.h"
#include "parser/blocks/build_view.h"
#include "parser/check/check_block.h"
#include "parser/evaluate/evaluator_state.h"

namespace lray::parser {

using scene::NodeId;

Evaluator::Head Evaluator::head(const BlockExpr& expr, bool is_placed) {
    if (expr.head->kind == ExprKind::name) {
        const NameExpr& built_in = static_cast<const NameExpr&>(*expr.head);
        if (built_in.meaning == Meaning::block) {
            return {&block_schema(static_cast<BlockKind>(built_in.index)), nullptr};
        }
    }
    const Value value = eval(*expr.head);
    if (value.is(ValueKind::poison)) return {};
    const bool is_surface = value.is(ValueKind::material) || value.is(ValueKind::texture);
    if (!is_surface && !value.is(ValueKind::node)) {
        error(
            Code::E0408, expr.head->span,
            fmt::format("`{}` is {}; only blocks take braces", text(*expr.head), describe(value)));
        return {};
    }
    if (is_surface && is_placed) {
        report_placed_value(value.made->schema->kind, text(*expr.head), expr.head->span,
                            diagnostics_);
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
    const bool is_texture_block = is_texture(schema.kind);
    if (!is_surface(schema.kind) && !schema.is_placeable) {
        error(Code::E0408, expr.head->span, fmt::format("a `{}` block is not a value", schema.name))
            .with_help("write it at the top level");
        return Value::poison();
    }
    OpenBlock open(schema, expr.span);
    if (made_of.made != nullptr) {
        open.values = *made_of.made->values;
        if (is_texture_block) {
            open.transform = scene_.textures[made_of.made->id].space_from_texture;
        } else if (!is_material) {
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
    if (is_texture_block) return make_texture(open);
    const std::optional<NodeId> node = make_node(open, expr.label);
    if (!node) return Value::poison();
    const PropertyValues* values = arena_.make<PropertyValues>(open.values);
    return Value::of_made(ValueKind::node, arena_.make<Made>(&schema, values, node->value));
}

Value Evaluator::make_material(const OpenBlock& open) {
    if (open.is_poisoned) return Value::poison();
    const scene::MaterialId id(scene_.materials.size());
    scene_.materials.push_back(
        build_material(open.values, scene_.textures, open.span, diagnostics_));
    const PropertyValues* values = arena_.make<PropertyValues>(open.values);
    return Value::of_made(ValueKind::material, arena_.make<Made>(&open.schema, values, id.value));
}

Value Evaluator::make_texture(const OpenBlock& open) {
    if (open.is_poisoned) return Value::poison();
    const std::uint64_t size = texture_size(open.values, open.schema);
    if (!take_bytes(budget_, size, open.span, diagnostics_)) return Value::poison();
    const auto id = build_texture(open.schema, open.values, open.value_spans, open.transform,
                                  open.span, files_, scene_);
    if (!id) return Value::poison();
    const PropertyValues* values = arena_.make<PropertyValues>(open.values);
    return Value::of_made(ValueKind::texture, arena_.make<Made>(&open.schema, values, id->value));
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
        if (use->part != scene::MeshUse::kAllParts) {
            // A name may return in every other part of a file, and be used in every mesh.
            const scene::Mesh& mesh = scene_.meshes[use->mesh_id.index()];
            const std::size_t count = parts_named(mesh, mesh.parts[use->part].name).size();
            if (!take_steps(budget_, count, open.span, diagnostics_)) return std::nullopt;
        }
        scene_.mesh_uses.push_back(*use);
        return ShapeRef{scene::NodeKind::mesh,
                        static_cast<std::uint32_t>(scene_.mesh_uses.size() - 1)};
    }
    if (is_light(open.schema.kind)) {
        return build_light(open.schema, open.values, open.value_spans, open.span, files_, scene_,
                           diagnostics_);
    }
    return build_shape(open.schema, open.values, open.span, scene_, diagnostics_);
}

NodeId Evaluator::add_node(const OpenBlock& open, scene::NodeKind kind, std::size_t index,
                           const StringExpr* label) {
    if (!open.scale_after_translate.is_nowhere()) {
        diagnostics_
            .warning(Code::W1301, open.scale_after_translate,
                     "`scale` after `translate` also multiplies the way it was moved")
            .with_help("scale first, or write the steps as `transform: [...]`");
    }
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

}  // namespace lray::parser
