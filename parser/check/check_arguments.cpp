#include "parser/check/check_arguments.h"

#include <fmt/format.h>

#include "base/suggest_name.h"

namespace lray::parser {

Signature signature_of(const Builtin& builtin) {
    Signature signature;
    signature.name = builtin.name;
    signature.is_variadic = builtin.is_variadic;
    for (std::size_t i = 0; i < builtin.parameter_count(); ++i) {
        const Parameter& parameter = builtin.parameters[i];
        signature.parameters.push_back({parameter.name, !parameter.is_optional});
    }
    return signature;
}

Signature signature_of(const Function& function, const Symbols& symbols) {
    Signature signature;
    signature.name = function.name == kNoSymbol ? std::string_view{"this function"}
                                                : symbols.text(function.name);
    for (const ParameterDecl& parameter : function.parameters) {
        signature.parameters.push_back(
            {symbols.text(parameter.name), parameter.default_value == nullptr});
    }
    return signature;
}

std::span<const std::uint8_t> check_arguments(const CallExpr& expr, const Signature& signature,
                                              const Symbols& symbols, Arena& arena,
                                              Diagnostics& diagnostics) {
    const std::vector<Signature::Parameter>& parameters = signature.parameters;
    if (parameters.size() > kMaxFunctionParameters) return {};  // reported where it is defined
    std::vector<Span> given(parameters.size());
    std::vector<std::uint8_t> places;
    bool has_named = false;
    for (const Argument& argument : expr.arguments) {
        std::size_t place = places.size();
        if (argument.name != kNoSymbol) {
            has_named = true;
            const std::string_view text = symbols.text(argument.name);
            place = 0;
            while (place < parameters.size() && parameters[place].name != text) ++place;
            if (place == parameters.size()) {
                std::vector<std::string_view> names;
                for (const Signature::Parameter& known : parameters) names.push_back(known.name);
                suggest_name(diagnostics.error(
                                 Code::E0306, argument.name_span,
                                 fmt::format("`{}` has no argument `{}`", signature.name, text)),
                             text, names);
                return {};
            }
        } else if (has_named) {
            diagnostics.error(Code::E0306, argument.value->span,
                              "arguments without a name come before those with one");
            return {};
        }
        if (place >= parameters.size()) {
            if (signature.is_variadic) {
                places.push_back(kRestPlace);
                continue;
            }
            diagnostics.error(Code::E0306, argument.value->span,
                              fmt::format("`{}` takes {} argument{}", signature.name,
                                          parameters.size(), parameters.size() == 1 ? "" : "s"));
            return {};
        }
        if (!given[place].is_nowhere()) {
            diagnostics
                .error(Code::E0306, argument.value->span,
                       fmt::format("`{}` is given twice", parameters[place].name))
                .with_label(given[place], "first given here");
            return {};
        }
        given[place] = argument.value->span;
        places.push_back(static_cast<std::uint8_t>(place));
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!parameters[i].is_required || !given[i].is_nowhere()) continue;
        diagnostics.error(
            Code::E0305, expr.span,
            fmt::format("`{}` needs its argument `{}`", signature.name, parameters[i].name));
        return {};
    }
    return arena.copy(places);
}

}  // namespace lray::parser
