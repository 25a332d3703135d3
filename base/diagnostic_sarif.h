// Diagnostics as a SARIF 2.1.0 log, for code hosts and editors.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"

namespace lray {

/// Returns one document with a line end, also when there is no diagnostic: at most `max_errors`
/// errors and as many warnings, 0: all. Columns count code points.
/// Source: OASIS 2020, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0".
std::string format_sarif(const Diagnostics& diagnostics, const Sources& sources,
                         std::size_t max_errors);

/// Returns a path as a URI reference: percent-encoded, and an absolute path as a `file` URI.
/// Source: RFC 3986, section 2, "Characters".
std::string uri_of(std::string_view path);

}  // namespace lray
