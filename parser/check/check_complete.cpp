#include "parser/check/check_complete.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace lray::parser {

namespace {

// Returns true if two forms are mixed.
bool mixes_forms(const BlockSchema& schema, std::span<const Span> set, Diagnostics& diagnostics) {
    const std::span<const PropertySchema> properties = schema.properties;
    std::array<std::size_t, kFormCount> slot_of{};  // the first one set, of each form
    slot_of.fill(properties.size());
    for (std::size_t slot = properties.size(); slot-- > 0;) {
        if (!set[slot].is_nowhere())
            slot_of[static_cast<std::size_t>(properties[slot].form)] = slot;
    }
    std::vector<std::size_t> mixed;  // in the order of forms
    for (std::size_t form = 1; form < kFormCount; ++form) {
        if (slot_of[form] < properties.size()) mixed.push_back(slot_of[form]);
    }
    if (mixed.size() < 2) return false;
    const std::size_t first = mixed[0];
    const std::size_t second = mixed[1];
    const bool first_is_later = set[first].offset > set[second].offset;
    const Span later = set[first_is_later ? first : second];
    const Span earlier = set[first_is_later ? second : first];
    diagnostics
        .error(Code::E0411, later,
               fmt::format("give `{}` or `{}`, not both", properties[first].name,
                           properties[second].name))
        .with_label(earlier, "the other one");
    return true;
}

bool lacks_required(const BlockSchema& schema, std::span<const Span> set, Span head,
                    Diagnostics& diagnostics) {
    const std::span<const PropertySchema> properties = schema.properties;
    Form form = Form::any;
    for (std::size_t slot = 0; slot < properties.size(); ++slot) {
        if (!set[slot].is_nowhere() && properties[slot].form != Form::any) {
            form = properties[slot].form;
        }
    }
    std::vector<std::string_view> missing;
    for (std::size_t slot = 0; slot < properties.size(); ++slot) {
        if (set[slot].is_nowhere() && is_needed(properties[slot], form)) {
            missing.push_back(properties[slot].name);
        }
    }
    if (missing.empty()) return false;
    std::string names;
    for (std::size_t i = 0; i < missing.size(); ++i) {
        const std::string_view joint = i == 0 ? "" : i + 1 == missing.size() ? " and " : ", ";
        names += fmt::format("{}`{}`", joint, missing[i]);
    }
    if (schema.kind == BlockKind::mesh && form != Form::second) {
        names = "`file`, or `positions` and `triangles`";
    }
    if (schema.kind == BlockKind::heightfield && form == Form::any) {
        names = "`height`, `heights` or `image`";
    }
    Diagnostic& diagnostic =
        diagnostics.error(Code::E0406, head, fmt::format("{} needs {}", schema.name, names));
    if (schema.kind == BlockKind::terrain) {
        diagnostic.with_help(
            "any number will do, like `seed: 1`; another one is another landscape");
    }
    return true;
}

}  // namespace

bool check_complete(const BlockSchema& schema, std::span<const Span> set, Span head, bool is_new,
                    Diagnostics& diagnostics) {
    // Of two forms mixed, what else is missing depends on which one is meant.
    if (mixes_forms(schema, set, diagnostics)) return false;
    return !is_new || !lacks_required(schema, set, head, diagnostics);
}

}  // namespace lray::parser
