// Evaluates blocks: materials, shapes, groups, meshes, instances, records, views.
#include <fmt/format.h>

#include <utility>

#include "base/assert.h"
#include "parser/blocks/build_heightfield.h"
#include "parser/blocks/build_light.h"
#include "parser/blocks/build_material.h"
#include "parser/blocks/build_mesh.h"
#include "parser/blocks/build_texture.h"
#include "parser/blocks/build_view.h"
#include "parser/check/check_block.h"
#include "parser/check/check_complete.h"
#include "parser/evaluate/evaluator_state.h"
#include "scene/formats/nff_nodes.h"

namespace lray::parser {

using scene::NodeId;

Evaluator::Head Evaluator::head(BlockExpr& expr, bool is_placed) {
    const NameExpr* named = nullptr;
    if (expr.head->kind == ExprKind::name) {
        named = static_cast<const NameExpr*>(expr.head);
    } else if (expr.head->kind == ExprKind::member) {
        named = static_cast<const MemberExpr&>(*expr.head).imported;
    }
    if (named != nullptr && named->meaning == Meaning::block) {
        return {&block_schema(static_cast<BlockKind>(named->index)), nullptr, nullptr};
    }
    if (named != nullptr && named->meaning == Meaning::component) {
        const FunctionUse& use = checked_.uses[named->index];
        return {use.function->schema, nullptr, &use};
    }
    const Value value = eval(*expr.head);
    if (value.is(ValueKind::poison)) return {};
    if (value.is(ValueKind::record) && !is_placed) {
        return {&block_schema(BlockKind::record), nullptr, nullptr, value};
    }
    const bool is_node = value.is(ValueKind::node);
    const bool is_made = is_node || value.is(ValueKind::material) || value.is(ValueKind::texture);
    if (!is_made && (!is_placed || !value.is(ValueKind::record))) {
        error(
            Code::E0408, expr.head->span,
            fmt::format("`{}` is {}; only blocks take braces", text(*expr.head), describe(value)));
        return {};
    }
    if (is_placed && !is_node) {
        const BlockKind kind =
            value.is(ValueKind::record) ? BlockKind::record : value.made->schema->kind;
        report_placed_value(kind, text(*expr.head), expr.head->span, diagnostics_);
        return {};
    }
    const BlockSchema& schema = *value.made->schema;
    if (expr.checked_as != &schema) {  // the checker could not tell, or it is not the same always
        const BlockUse use = is_placed ? BlockUse::instance : BlockUse::copy;
        Diagnostics again;
        if (!check_block(schema, expr, use, symbols_, sources_, again)) {
            diagnostics_.append(again);
            return {};
        }
        expr.checked_as = &schema;
    }
    return {&schema, value.made, nullptr};
}

void Evaluator::placed_block(BlockExpr& expr, OpenBlock& open) {
    const Head made_of = head(expr, true);
    if (made_of.schema == nullptr) {
        ++failures_;
        return;
    }
    if (made_of.schema->kind == BlockKind::material) {  // inline: `sphere { material { } }`
        OpenBlock inner(*made_of.schema, expr.span);
        const bool is_whole = body(expr, inner);
        open.material_id = is_whole ? add_material(inner) : std::nullopt;
        Span& first = open.common_spans[0];
        if (!first.is_nowhere()) {
            error(Code::E0402, expr.head->span, "`material` is set twice")
                .with_label(first, "first set here");
            ++failures_;
        }
        first = expr.head->span;
        open.is_poisoned = open.is_poisoned || !is_whole;
        return;
    }
    if (!made_of.schema->is_placeable) {
        view_block(*made_of.schema, expr);
        return;
    }
    const std::uint64_t failures = failures_;
    std::optional<NodeId> child;
    if (made_of.component != nullptr) {
        child = place_component(expr, *made_of.component);
    } else if (made_of.made != nullptr) {
        child = instance(expr, *made_of.made);
    } else {
        OpenBlock inner(*made_of.schema, expr.span);
        if (body(expr, inner)) child = make_node(inner, expr.label);
    }
    if (child) {
        open.children.push_back(*child);
    } else if (failures == failures_) {
        ++failures_;
    }
}

// Evaluates what stands between the braces. False: something is wrong with it.
bool Evaluator::body(const BlockExpr& expr, OpenBlock& open, bool is_new) {
    items(expr.body.items, open);
    if (open.is_poisoned) return false;
    if (!expr.has_statements || open.schema.kind == BlockKind::record) return true;
    const bool is_whole =
        check_complete(open.schema, open.value_spans, expr.head->span, is_new, diagnostics_);
    if (!is_whole) ++failures_;
    return is_whole;
}

// A copy begins as what it is a copy of.
void Evaluator::start_copy(const Made& made, OpenBlock& open) {
    for (std::size_t slot = 0; slot < made.schema->properties.size(); ++slot) {
        open.values.set(slot, made.values[slot]);
    }
    if (is_texture(made.schema->kind)) {
        open.transform = scene_.textures[made.id].space_from_texture;
    }
    if (!made.schema->is_placeable) return;
    const scene::Node& original = scene_.nodes[made.id];
    if (!original.transform_id.is_none()) {
        open.transform = scene_.transforms[original.transform_id.index()];
        open.has_steps = true;
    }
    if (!original.material_id.is_none()) open.material_id = original.material_id;
    open.visible = original.visible;
    open.casts_shadow = original.casts_shadow;
    if (made.component == nullptr && original.kind == scene::NodeKind::group) {
        open.children = scene_.groups[original.index].children;
    }
}

// A block in the place of a value: a material, a record, or a node that is not placed.
Value Evaluator::block_value(BlockExpr& expr) {
    const Head made_of = head(expr, false);
    if (made_of.schema == nullptr) return Value::poison();
    const BlockSchema& schema = *made_of.schema;
    OpenBlock open(schema, expr.span);
    if (schema.kind == BlockKind::record) {
        const Value& original = made_of.record;
        if (original.is(ValueKind::record)) {
            if (!take_share(original.count, expr.span)) return Value::poison();
            open.record.copy(original);
        }
        return body(expr, open) ? record_value(open) : Value::poison();
    }
    if (!is_surface(schema.kind) && !schema.is_placeable) {
        error(Code::E0408, expr.head->span, fmt::format("a `{}` block is not a value", schema.name))
            .with_help("write it at the top level");
        return Value::poison();
    }
    if (made_of.made != nullptr) {
        start_copy(*made_of.made, open);
        const std::uint64_t size = open.children.size() * sizeof(NodeId);
        if (!take_kept_bytes(budget_, size, expr.span, diagnostics_)) return Value::poison();
    }
    if (!body(expr, open, made_of.made == nullptr)) return Value::poison();
    if (schema.kind == BlockKind::material) {
        const std::optional<scene::MaterialId> id = add_material(open);
        return id ? made_value(ValueKind::material, open, id->value) : Value::poison();
    }
    if (is_texture(schema.kind)) {
        const std::optional<scene::TextureId> id = add_texture(open);
        return id ? made_value(ValueKind::texture, open, id->value) : Value::poison();
    }
    if (schema.kind == BlockKind::component) {
        const Made* const made = made_of.made;
        const FunctionValue component =
            made != nullptr ? *made->component : captured(*made_of.component);
        const NodeId children =
            open.children.empty() && made != nullptr ? made->children : children_of(open);
        const std::optional<NodeId> node = make_component(open, component, children, expr.label);
        if (!node) return Value::poison();
        Value value = made_value(ValueKind::node, open, node->value);
        if (value.is(ValueKind::poison)) return value;
        Made* const kept = memory_.kept().make<Made>(*value.made);
        FunctionValue* const kept_component = memory_.kept().make<FunctionValue>(component);
        kept_component->captures =
            keep_all({component.captures, component.function->capture_slots.size()}, expr.span);
        if (kept_component->captures == nullptr) return Value::poison();
        kept->component = kept_component;
        kept->children = children;
        value.made = kept;
        return value;
    }
    const std::optional<NodeId> node = make_node(open, expr.label);
    return node ? made_value(ValueKind::node, open, node->value) : Value::poison();
}

// Null: there is no memory left for it.
const Value* Evaluator::keep_all(std::span<const Value> values, Span span) {
    ValueCopier keeper = memory_.keeper();
    std::vector<Value> kept(values.begin(), values.end());
    for (Value& value : kept) value = keeper.copy(value);
    if (!take_kept_bytes(budget_, keeper.size(), span, diagnostics_)) return nullptr;
    kept.emplace_back();  // so that nothing is kept somewhere, too
    return memory_.kept().copy(kept).data();
}

Value Evaluator::made_value(ValueKind kind, const OpenBlock& open, std::uint32_t id) {
    const std::span<const Value> values = open.values.all();
    const std::uint64_t size = sizeof(Made) + values.size_bytes();
    if (!take_kept_bytes(budget_, size, open.span, diagnostics_)) return Value::poison();
    Made made;
    made.schema = &open.schema;
    made.values = keep_all(values, open.span);
    if (made.values == nullptr) return Value::poison();
    made.id = id;
    return Value::of_made(kind, memory_.kept().make<Made>(made));
}

Value Evaluator::record_value(const OpenBlock& open) {
    std::uint8_t depth = 0;
    for (const RecordField& field : open.record.fields())
        depth = std::max(depth, field.value.depth());
    if (depth >= kMaxValueDepth) {
        return failed(
            Code::E0514, open.span,
            fmt::format("lists and records are nested more than {} deep", kMaxValueDepth));
    }
    const std::uint64_t size = open.record.fields().size() * sizeof(RecordField);
    if (!take_bytes(budget_, size, open.span, diagnostics_)) return Value::poison();
    return Value::of_record(arena().copy(open.record.fields()),
                            static_cast<std::uint8_t>(depth + 1));
}

std::optional<scene::MaterialId> Evaluator::add_material(const OpenBlock& open) {
    const scene::MaterialId id(scene_.materials.size());
    if (!take_kept_bytes(budget_, sizeof(scene::Material), open.span, diagnostics_)) {
        return std::nullopt;
    }
    scene_.materials.push_back(
        build_material(open.values, scene_.textures, open.span, diagnostics_));
    return id;
}

std::optional<scene::TextureId> Evaluator::add_texture(const OpenBlock& open) {
    const std::uint64_t size = texture_size(open.values, open.schema);
    if (!take_kept_bytes(budget_, size, open.span, diagnostics_)) return std::nullopt;
    return build_texture(open.schema, open.values, open.value_spans, open.transform, open.span,
                         files_, scene_);
}

void Evaluator::view_block(const BlockSchema& schema, BlockExpr& expr) {
    OpenBlock open(schema, expr.span);
    if (!body(expr, open)) return;
    if (schema.kind == BlockKind::camera) {
        const std::string_view name =
            expr.label != nullptr ? expr.label->value : std::string_view{};
        const std::uint64_t size = sizeof(scene::Camera) + name.size();
        if (!take_kept_bytes(budget_, size, expr.span, diagnostics_)) return;
        if (auto camera = build_camera(open.values, name, expr.head->span, diagnostics_)) {
            scene_.cameras.push_back(std::move(*camera));
        }
    } else if (schema.kind == BlockKind::render) {
        scene_.render = build_render_settings(open.values);
        has_render_ = true;
    }
}

// The background goes with the view. Without one it is the scene's, unless `render` says which.
void Evaluator::file_view(const FileViewItem& item) {
    if (!item.is_top_level) return;
    if (!item.has_view) {
        if (item.has_background && !has_render_) scene_.render.background = item.background;
        return;
    }
    const std::uint64_t size = sizeof(scene::Camera) + item.name.size();
    if (!take_kept_bytes(budget_, size, item.span, diagnostics_)) return;
    scene::Camera camera = scene::camera_of(item.view);
    camera.name = std::string(item.name);
    if (item.has_background) camera.background = item.background;
    scene_.cameras.push_back(std::move(camera));
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
        if (!take_kept_bytes(budget_, size, open.span, diagnostics_)) return std::nullopt;
        const std::optional<scene::MeshUse> use =
            build_mesh(open.values, open.value_spans, open.span, open.material_id.has_value(),
                       files_, scene_, diagnostics_);
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
    if (open.schema.kind == BlockKind::heightfield || open.schema.kind == BlockKind::terrain) {
        const HeightProperties properties{open.values, open.value_spans, open.span};
        const HeightBuild build{files_, budget_, *this, scene_, diagnostics_};
        const std::optional<scene::MeshUse> use = open.schema.kind == BlockKind::terrain
                                                      ? build_terrain(properties, build)
                                                      : build_heightfield(properties, build);
        if (!use) return std::nullopt;
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
    if (open.material_id) {
        node.material_id = *open.material_id;
    } else if (kind == scene::NodeKind::mesh) {
        node.material_id = own_material_of(scene_.mesh_uses[index]);
    }
    if (label != nullptr) {
        node.label_id = scene::LabelId(scene_.labels.size());
        take_kept_bytes(budget_, label->value.size(), label->span, diagnostics_);
        scene_.labels.emplace_back(label->value);
    }
    return push_node(node);
}

// What a mesh without a material is shown in, of what it says itself; none: what it inherits.
scene::MaterialId Evaluator::own_material_of(const scene::MeshUse& use) {
    const scene::Mesh& mesh = scene_.meshes[use.mesh_id.index()];
    const bool is_refused = !mesh.file.empty() && !use.shows_materials;  // by use_mtl
    if (is_refused || !shows_own_colors(mesh)) return {};
    if (!vertex_colors_) vertex_colors_ = add_vertex_colors_material(scene_);
    return *vertex_colors_;
}

// Every node that running the scene makes comes through here.
NodeId Evaluator::push_node(const scene::Node& node) {
    const std::uint64_t limit = environment_.settings.limits.nodes;
    if (scene_.nodes.size() >= limit && !budget_.is_spent) too_many_nodes(node.span);
    scene_.nodes.push_back(node);
    return NodeId(scene_.nodes.size() - 1);
}

void Evaluator::too_many_nodes(Span span) {
    error(Code::E0513, span,
          fmt::format("the scene has more than {} nodes", environment_.settings.limits.nodes))
        .with_help("raise the limit with `--max-nodes N`");
    budget_.spend();
}

}  // namespace lray::parser
