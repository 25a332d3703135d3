#include "parser/check/check_arguments.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "base/suggest_name.h"

namespace lray::parser {

void check_arguments(const CallExpr& expr, const Builtin& builtin, const Symbols& symbols,
                     Diagnostics& diagnostics) {
    const std::size_t count = builtin.parameter_count();
    std::array<Span, kMaxParameters> given{};
    std::size_t position = 0;
    bool has_named = false;
    for (const Argument& argument : expr.arguments) {
        std::size_t place = position++;
        if (argument.name != kNoSymbol) {
            has_named = true;
            const std::string_view text = symbols.text(argument.name);
            place = 0;
            while (place < count && builtin.parameters[place].name != text) ++place;
            if (place == count) {
                std::vector<std::string_view> names;
                for (std::size_t i = 0; i < count; ++i) names.push_back(builtin.parameters[i].name);
                suggest_name(
                    diagnostics.error(Code::E0306, argument.name_span,
                                      fmt::format("`{}` has no argument `{}`", builtin.name, text)),
                    text, names);
                return;
            }
        } else if (has_named) {
            diagnostics.error(Code::E0306, argument.value->span,
                              "arguments without a name come before those with one");
            return;
        }
        if (place >= count) {
            diagnostics.error(Code::E0306, argument.value->span,
                              fmt::format("`{}` takes {} argument{}", builtin.name, count,
                                          count == 1 ? "" : "s"));
            return;
        }
        if (!given[place].is_nowhere()) {
            diagnostics
                .error(Code::E0306, argument.value->span,
                       fmt::format("`{}` is given twice", builtin.parameters[place].name))
                .with_label(given[place], "first given here");
            continue;
        }
        given[place] = argument.value->span;
    }
    for (std::size_t i = 0; i < builtin.required_count(); ++i) {
        if (!given[i].is_nowhere()) continue;
        diagnostics.error(
            Code::E0305, expr.span,
            fmt::format("`{}` needs its argument `{}`", builtin.name, builtin.parameters[i].name));
        return;
    }
}

}  // namespace lray::parser
