// Cuts OBJ text between statements, so that its pieces can be read at the same time.
#pragma once

#include <cstddef>
#include <vector>

#include "base/source.h"

namespace lray::scene::obj {

/// Shape: a place in a text, and one at or behind it.
struct TextRange {
    const char* begin = nullptr;
    const char* end = nullptr;
};

/// Returns all of a text but its byte order mark.
TextRange whole(const Text& text);

/// Returns ranges that make up whole(), each but the last of `size` bytes and what is left of its
/// last statement; one only of a text that is not much longer.
/// Shape: size > 0.
std::vector<TextRange> cut(const Text& text, std::size_t size);

}  // namespace lray::scene::obj
