#include "parser/builtins/builtins.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "parser/builtins/families.h"

namespace lray::parser {

namespace {

/// In the order of the reference. A family is added here, and in families.h.
std::array<BuiltinFamily, 11> all_families() {
    return {{
        {"Numbers", number_builtins()},
        {"Vectors", vector_builtins()},
        {"Lists", list_builtins()},
        {"Strings", string_builtins()},
        {"Colours", color_builtins()},
        {"Transforms", transform_builtins()},
        {"Geometry", geometry_builtins()},
        {"Noise", noise_builtins()},
        {"Random numbers", random_builtins()},
        {"Animation", animation_builtins()},
        {"Messages", message_builtins()},
    }};
}

struct Table {
    std::vector<Builtin> functions{};
    std::vector<std::uint32_t> by_name{};  // indices, sorted by name

    Table() {
        for (const BuiltinFamily& family : builtin_families()) {
            functions.insert(functions.end(), family.functions.begin(), family.functions.end());
        }
        by_name.resize(functions.size());
        std::iota(by_name.begin(), by_name.end(), std::uint32_t{0});
        std::sort(by_name.begin(), by_name.end(), [this](std::uint32_t a, std::uint32_t b) {
            return functions[a].name < functions[b].name;
        });
    }
};

const Table& table() {
    static const Table table;
    return table;
}

bool is_usable(const Builtin& builtin, std::string_view what, ParameterType type,
               const Value& argument, Span span, Diagnostics& diagnostics) {
    if (argument.is(ValueKind::none) || fits(type, argument)) return true;
    using enum ParameterType;
    const bool is_number = argument.is(ValueKind::number) && type == integer;
    const bool is_vector =
        argument.is(ValueKind::numbers) && (type == vec3 || type == ParameterType::vector);
    const Code code = is_vector ? Code::E0303 : is_number ? Code::E0308 : Code::E0301;
    diagnostics.error(
        code, span,
        fmt::format("{} of `{}` needs {}, this is {}", what, builtin.name, in_words(type),
                    is_number ? format_number(argument.number) : describe(argument)));
    return false;
}

}  // namespace

std::size_t Builtin::parameter_count() const {
    std::size_t count = 0;
    while (count < kMaxParameters && !parameters[count].name.empty()) ++count;
    return count;
}

std::size_t Builtin::required_count() const {
    std::size_t count = 0;
    while (count < parameter_count() && !parameters[count].is_optional) ++count;
    return count;
}

std::span<const BuiltinFamily> builtin_families() {
    static const std::array families = all_families();
    return families;
}

std::span<const Builtin> builtins() {
    return table().functions;
}

std::optional<std::uint32_t> find_builtin(std::string_view name) {
    const Table& known = table();
    const auto found = std::lower_bound(known.by_name.begin(), known.by_name.end(), name,
                                        [&](std::uint32_t index, std::string_view wanted) {
                                            return known.functions[index].name < wanted;
                                        });
    if (found == known.by_name.end() || known.functions[*found].name != name) return std::nullopt;
    return *found;
}

Value call_builtin(const Builtin& builtin, Call& call) {
    for (std::size_t i = 0; i < kMaxParameters; ++i) {
        const Parameter& parameter = builtin.parameters[i];
        if (parameter.name.empty()) break;
        const Value& argument = call.arguments[i];
        if (argument.is(ValueKind::poison)) return argument;
        if (fits(parameter.type, argument)) continue;
        if (!is_usable(builtin, fmt::format("`{}`", parameter.name), parameter.type, argument,
                       call.spans[i], call.diagnostics)) {
            return Value::poison();
        }
    }
    for (std::size_t i = 0; i < call.rest.size(); ++i) {
        if (call.rest[i].is(ValueKind::poison)) return Value::poison();
        if (!is_usable(builtin, "every argument", builtin.rest_type, call.rest[i],
                       call.rest_spans[i], call.diagnostics)) {
            return Value::poison();
        }
    }
    call.name = builtin.name;
    return builtin.function(call);
}

}  // namespace lray::parser
