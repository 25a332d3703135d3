// Puts a suggestion for a misspelt name into a diagnostic.
#pragma once

#include <span>
#include <string_view>

#include "base/diagnostics.h"

namespace lray {

/// Adds the hint "did you mean ...?"; when a single name is near it is also the fix. Returns
/// whether anything is near. Shape: the diagnostic's span is that of the name.
bool suggest_name(Diagnostic& diagnostic, std::string_view name,
                  std::span<const std::string_view> candidates);

}  // namespace lray
