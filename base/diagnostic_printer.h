// Diagnostics as text for people: excerpt, carets, labels, include stack, colours.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray {

struct PrintOptions {
    bool color = false;
    std::size_t max_errors = 20;  // 0: all
};

/// Returns all diagnostics as text, each followed by an empty line, and no closing line.
/// Layout: docs/diagnostics.md. Control characters of the input are escaped.
std::string format_diagnostics(const Diagnostics& diagnostics, const Sources& sources,
                               const PrintOptions& options);

/// Returns "2 errors, 1 warning", or an empty string when there are none.
std::string summary(const Diagnostics& diagnostics);

/// Returns the text with control characters, invalid UTF-8 and bidirectional overrides written as
/// escapes (`\u{1b}`), so that nothing from a scene can command a terminal.
std::string escape_for_terminal(std::string_view text);

}  // namespace lray
