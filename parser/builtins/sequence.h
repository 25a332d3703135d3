// Elements on their way into a list.
#pragma once

#include <span>
#include <vector>

#include "parser/builtins/builtins.h"

namespace lray::parser {

/// Gathers the elements of a list that a built-in function returns. Each is paid for before it is
/// stored, and counted against the limit of a list.
class Sequence {
 public:
    explicit Sequence(Call& call) : call_(call) {}

    /// Errors: false, E0514, E0512 or E0516 reported at the call.
    bool add(const Value& element);

    /// Adds the elements of a list. Errors: as add().
    bool add_all(const Value& list);

    std::span<Value> elements() { return elements_; }

    /// Returns the list. Errors: as make_list().
    Value finish();

 private:
    bool may_add(std::uint64_t count);

    Call& call_;
    std::vector<Value> elements_;
};

}  // namespace lray::parser
