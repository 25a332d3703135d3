#include "parser/evaluate/listed_params.h"

#include <cmath>
#include <optional>
#include <utility>

#include "parser/values/literal_text.h"
#include "parser/values/operators.h"
#include "parser/values/value_text.h"

namespace lray::parser {

bool is_whole_range(const Value& fallback, const Value& choices) {
    const auto is_whole = [](double x) { return x == std::floor(x); };
    return fallback.is(ValueKind::number) && is_whole(fallback.number) &&
           is_whole(choices.numbers[0]) && is_whole(choices.numbers[1]);
}

void ListedParams::add(const Param& param, const Value& value, const Value& fallback,
                       const Value& choices) {
    if (list_.size() == kMaxListedParams) return;
    ParamValue& listed = list_.emplace_back();
    listed.name = param.name;
    listed.place = param.item->name_span;
    const std::optional<std::string> now = literal_text(value, kMaxParamText);
    const std::optional<std::string> before = literal_text(fallback, kMaxParamText);
    listed.has_literals = now && before;
    listed.value = now ? *now : value_text(value, symbols_, kMaxParamText);
    listed.default_value = before ? *before : value_text(fallback, symbols_, kMaxParamText);
    if (choices.is_vector(2)) {
        const bool is_whole =
            is_whole_range(fallback, choices) || param.item->type == TypeName::integer;
        listed.range = {choices.numbers[0], choices.numbers[1], value.number, fallback.number,
                        is_whole};
    } else if (choices.is_list() && listed.has_literals) {
        listed.choices = choices_of(choices);
    }
}

// All of them, or none.
std::vector<std::string> ListedParams::choices_of(const Value& list) {
    if (list.count > kMaxListedChoices) return {};
    std::vector<std::string> choices;
    std::size_t size = 0;
    for (std::uint32_t i = 0; i < list.count; ++i) {
        std::optional<std::string> choice = literal_text(element(list, i), kMaxParamText);
        if (!choice || size + choice->size() > choices_text_left_) return {};
        size += choice->size();
        choices.push_back(std::move(*choice));
    }
    choices_text_left_ -= size;
    return choices;
}

}  // namespace lray::parser
