#include "scene/formats/ply_row.h"

namespace lray::scene::ply {

RowPlan plan_row(const Element& element) {
    RowPlan plan;
    RowStep step;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const Property& property = element.properties[i];
        plan.offsets.push_back(plan.packed_size);
        if (property.is_list) {
            step.has_list = true;
            step.count_type = property.count_type;
            step.item_type = property.type;
            step.property = i;
            plan.steps.push_back(step);
            step = {};
        } else {
            step.fixed_size += size_of(property.type);
            plan.packed_size += size_of(property.type);
        }
    }
    plan.steps.push_back(step);
    return plan;
}

}  // namespace lray::scene::ply
