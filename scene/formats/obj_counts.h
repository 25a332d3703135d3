// How many statements of each kind OBJ text has.
#pragma once

#include <cstddef>

#include "base/source.h"

namespace lray::scene::obj {

struct Counts {
    std::size_t positions = 0;
    std::size_t uvs = 0;
    std::size_t normals = 0;
    std::size_t faces = 0;
    std::size_t corners = 0;

    Counts& operator+=(const Counts& other);
};

/// Returns the exact counts: malformed statements count too.
Counts count_statements(const Text& text);

/// Returns those of the statements that begin in [begin, end) of a text, `begin` of a line.
Counts count_statements(const char* begin, const char* end);

/// Returns counts that are nearly right or slightly high, from samples, in a fraction of the time
/// it takes to read the text; never more than its bytes can hold.
Counts estimate_counts(const Text& text);

}  // namespace lray::scene::obj
