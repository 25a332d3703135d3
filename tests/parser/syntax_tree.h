// Parses text without loading it, and prints its tree, for tests of the syntax alone.
#pragma once

#include <string>
#include <string_view>

namespace lray::test {

/// What the parser makes of a text.
struct Parsed {
    std::string tree{};    // one line per item of the file
    std::string errors{};  // one line each, in the order of printing: "E0401 1:10 message"
    std::size_t error_count = 0;
    std::size_t node_count = 0;  // of literals that were decoded while parsing
    std::size_t import_count = 0;
};

/// Shape of the tree: (operator operand ...), [elements], {items}; what is packed begins with `#`.
Parsed parse_text(std::string_view text, std::uint32_t max_nesting = 256);

}  // namespace lray::test
