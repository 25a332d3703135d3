// Names as numbers: each identifier is stored once and compared as an index.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "parser/arena.h"

namespace lray::parser {

using Symbol = std::uint32_t;
inline constexpr Symbol kNoSymbol = 0xffffffffu;

/// All identifiers of a load. The keywords come first, in the order of TokenKind, then the built-in
/// blocks, in the order of BlockKind.
class Symbols {
 public:
    Symbols();

    Symbol intern(std::string_view name);
    std::string_view text(Symbol symbol) const { return names_[symbol]; }

 private:
    void grow();

    Arena arena_;
    std::vector<std::string_view> names_;
    std::vector<Symbol> table_;  // open addressing, a power of two, at most half full
};

}  // namespace lray::parser
