#include "parser/builtins/sequence.h"

#include "parser/builtins/results.h"

namespace lray::parser {

bool Sequence::may_add(std::uint64_t count) {
    const auto size = static_cast<double>(elements_.size() + count);
    return may_have_elements(call_.budget, size, call_.span, call_.diagnostics) &&
           take_bytes(call_.budget, count * sizeof(Value), call_.span, call_.diagnostics) &&
           take_steps(call_, count);
}

bool Sequence::add(const Value& element) {
    if (!may_add(1)) return false;
    elements_.push_back(element);
    return true;
}

bool Sequence::add_all(const Value& list) {
    if (!may_add(list.count)) return false;
    for (std::uint32_t i = 0; i < list.count; ++i) elements_.push_back(element(list, i));
    return true;
}

Value Sequence::finish() {
    return list_of(call_, elements_);
}

}  // namespace lray::parser
