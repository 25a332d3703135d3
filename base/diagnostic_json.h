// Diagnostics as JSON Lines: an object for each, for editors and scripts. The fields are described
// in docs/diagnostics.md.
#pragma once

#include <cstddef>
#include <string>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray {

/// Returns a line for each diagnostic, in the order of printing: at most `max_errors` errors and as
/// many warnings, 0: all. Every object has all fields; lines and columns count code points from 1,
/// offsets and lengths bytes.
std::string format_json(const Diagnostics& diagnostics, const Sources& sources,
                        std::size_t max_errors);

}  // namespace lray
