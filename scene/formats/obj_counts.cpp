#include "scene/formats/obj_counts.h"

#include <algorithm>

#include "scene/formats/obj_scanner.h"

namespace lray::scene::obj {

namespace {

std::size_t count_corners(const char* at, const char* end) {
    std::size_t count = 0;
    for (at = skip_blanks(at + 1); at < end && !is_line_end(*at); at = skip_blanks(at)) {
        ++count;
        at = skip_token(at);
    }
    return count;
}

/// Adds the statements that begin in [at, end) to `counts`; `at` is the begin of a line.
void add_statements(const char* at, const char* end, Counts& counts) {
    while (at < end) {
        while (is_blank(*at) || *at == '\n' || *at == '\r') ++at;
        if (at >= end) return;
        const char* const begin = at;
        switch (statement_at(at)) {
            case Statement::position:
                ++counts.positions;
                break;
            case Statement::uv:
                ++counts.uvs;
                break;
            case Statement::normal:
                ++counts.normals;
                break;
            case Statement::face:
                ++counts.faces;
                counts.corners += count_corners(at, end);
                break;
            case Statement::group:
            case Statement::object:
            case Statement::material:
            case Statement::smoothing:
            case Statement::free_form:
                break;
            case Statement::library:
            case Statement::other:
                at = find_line_end(at, end);
                if (*at == '\0') ++at;
                continue;
        }
        at = find_statement_end(begin, at, end);
        if (*at == '\0') ++at;
    }
}

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
    positions += other.positions;
    uvs += other.uvs;
    normals += other.normals;
    faces += other.faces;
    corners += other.corners;
    return *this;
}

Counts count_statements(const char* begin, const char* end) {
    Counts counts;
    add_statements(begin, end, counts);
    return counts;
}

Counts count_statements(const Text& text) {
    return count_statements(text.data(), text.data() + text.size());
}

Counts estimate_counts(const Text& text) {
    constexpr std::size_t kWindowCount = 64;
    constexpr std::size_t kWindowSize = std::size_t{1} << 14;
    const std::size_t size = text.size();
    if (size <= kWindowCount * kWindowSize) return count_statements(text);

    Counts counts;
    for (std::size_t i = 0; i < kWindowCount; ++i) {
        const char* const window = text.data() + size / kWindowCount * i;
        const char* const end = window + kWindowSize;
        add_statements(i == 0 ? window : find_line_end(window, end), end, counts);
    }
    // Where positions end and faces begin lies between two windows: one of them in doubt.
    const double scale = static_cast<double>(size) / static_cast<double>(kWindowSize);
    const auto scaled = [&](std::size_t count, std::size_t least_bytes) {
        if (count == 0) return std::size_t{0};
        const double windows = static_cast<double>(count) / static_cast<double>(kWindowCount);
        constexpr double kMargin = 1.0 + 2.0 / static_cast<double>(kWindowCount);
        return std::min(static_cast<std::size_t>(windows * scale * kMargin), size / least_bytes);
    };
    // The bytes of "v 0 0 0", "vt 0", "f 1 1 1" and " 1" with the line end.
    return {scaled(counts.positions, 8), scaled(counts.uvs, 5), scaled(counts.normals, 9),
            scaled(counts.faces, 8), scaled(counts.corners, 2)};
}

}  // namespace lray::scene::obj
