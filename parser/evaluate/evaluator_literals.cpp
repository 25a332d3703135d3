// Places the blocks of literals that the parser has made nodes of, and gives them their material.
#include <span>

#include "parser/blocks/property_type.h"
#include "parser/evaluate/evaluator_state.h"
#include "parser/syntax/literal_block.h"

namespace lray::parser {

void Evaluator::literals(const LiteralsItem& item, OpenBlock& open) {
    // A group is made of values, and pays for what it holds.
    const std::uint64_t size = std::uint64_t{item.count} * sizeof(scene::NodeId);
    const bool is_paid =
        open.span.is_nowhere() || (take_share(item.count, item.span) &&
                                   take_kept_bytes(budget_, size, item.span, diagnostics_));
    if (!is_paid) return;
    if (item.material != nullptr && !give_material(item)) return;
    for (std::uint32_t i = 0; i < item.count; ++i) {
        open.children.push_back(scene::NodeId(item.first_node + i));
    }
}

// Nothing runs between the blocks of an item: the name has one value for all of them.
bool Evaluator::give_material(const LiteralsItem& item) {
    const std::span<scene::Node> nodes =
        std::span(scene_.nodes).subspan(item.first_node, item.count);
    const std::optional<scene::MaterialId> material_id = material_of_literals(*item.material);
    if (material_id) {
        for (scene::Node& node : nodes) node.material_id = *material_id;
        return true;
    }
    for (const scene::Node& node : nodes.subspan(1)) {  // what is wrong is told of each
        NameExpr name = *item.material;
        name.span = material_name(node.span, sources_);
        material_of_literals(name);
    }
    return false;
}

std::optional<scene::MaterialId> Evaluator::material_of_literals(const NameExpr& name) {
    const Value fitted = fit(common_schema(CommonProperty::material), eval(name), name.span,
                             diagnostics_, text(name));
    if (fitted.is(ValueKind::poison)) {
        ++failures_;
        return std::nullopt;
    }
    return scene::MaterialId(fitted.made->id);
}

}  // namespace lray::parser
