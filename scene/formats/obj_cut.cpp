#include "scene/formats/obj_cut.h"

#include <cstring>
#include <string_view>

#include "base/assert.h"

namespace lray::scene::obj {

namespace {

/// Returns the begin of a line from `at` on that the line before does not go on in; or `end`. Lines
/// that end in `\r` alone do not count.
const char* find_statement_begin(const char* at, const char* begin, const char* end) {
    while (at < end) {
        const void* const found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
        if (found == nullptr) return end;
        const char* const line_end = static_cast<const char*>(found);
        const char* last = line_end;
        if (last > begin && last[-1] == '\r') --last;
        if (last == begin || last[-1] != '\\') return line_end + 1;
        at = line_end + 1;
    }
    return end;
}

}  // namespace

TextRange whole(const Text& text) {
    const char* const begin = text.data();
    return {text.view().starts_with("\xEF\xBB\xBF") ? begin + 3 : begin, begin + text.size()};
}

std::vector<TextRange> cut(const Text& text, std::size_t size) {
    LRAY_ASSERT(size > 0);
    TextRange rest = whole(text);
    std::vector<TextRange> ranges;
    while (static_cast<std::size_t>(rest.end - rest.begin) > size + size / 2) {
        const char* const middle = find_statement_begin(rest.begin + size, rest.begin, rest.end);
        if (middle == rest.end) break;
        ranges.push_back({rest.begin, middle});
        rest.begin = middle;
    }
    ranges.push_back(rest);
    return ranges;
}

}  // namespace lray::scene::obj
