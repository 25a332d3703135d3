// UTF-8: the code point at the begin of a text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace lray {

struct DecodedCodePoint {
    std::uint32_t code_point = 0;
    std::size_t size = 0;  // 0: the first byte begins no well-formed sequence
};

/// Source: The Unicode Standard 15, table 3-7, "Well-Formed UTF-8 Byte Sequences".
DecodedCodePoint decode_utf8(std::string_view text);

}  // namespace lray
