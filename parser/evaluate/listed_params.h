// Lists the params of a scene, with their values and what they may be, for those who change them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "parser/check/checker.h"
#include "parser/load.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Bounded by kMaxListedParams and what follows it, whatever the scene says.
class ListedParams {
 public:
    explicit ListedParams(const Symbols& symbols) : symbols_(symbols) {}

    /// Adds a param whose value and default fit what follows `in`; `choices` is none without that.
    void add(const Param& param, const Value& value, const Value& fallback, const Value& choices);

    std::vector<ParamValue> take() { return std::move(list_); }

 private:
    std::vector<std::string> choices_of(const Value& list);

    const Symbols& symbols_;
    std::vector<ParamValue> list_;
    std::size_t choices_text_left_ = kMaxChoicesText;
};

/// True for a param between two whole numbers whose default is whole: it has whole values only.
bool is_whole_range(const Value& fallback, const Value& choices);

}  // namespace lray::parser
