// Diagnostics as text for people: excerpt, carets, labels, include stack, colours.
#pragma once

#include <cstddef>
#include <string>

#include "base/diagnostics.h"
#include "base/source.h"
#include "base/terminal_text.h"

namespace lray {

struct PrintOptions {
    bool color = false;
    std::size_t max_errors = 20;  // and as many warnings; 0: all
};

/// Returns all diagnostics as text, each followed by an empty line, then a line that counts those
/// left out, and no closing line. Layout: docs/diagnostics.md. Control characters are escaped.
std::string format_diagnostics(const Diagnostics& diagnostics, const Sources& sources,
                               const PrintOptions& options);

/// Returns "2 errors, 1 warning", or an empty string when there are none.
std::string summary(const Diagnostics& diagnostics);

}  // namespace lray
