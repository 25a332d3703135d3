// Where a diagnostic points, as every form of output tells it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/source.h"

namespace lray {

/// False where the text is no longer held, and line and column cannot be told.
bool has_position(const Sources& sources, Span span);

/// Returns "room.lrs:12:3", without line and column where the text is gone: as it may be sent to a
/// terminal. The span is not nowhere.
std::string place_text(const Sources& sources, Span span);

/// Begin and end of a span, the end being behind its last character.
struct Extent {
    Position begin{};
    Position end{};
};

/// Returns nothing for nowhere, and where has_position() is false.
std::optional<Extent> extent_of(const Sources& sources, Span span);

/// Returns the includes that brought the source of a span, the innermost first; none for the main
/// file.
std::vector<Span> includes_of(const Sources& sources, Span span);

}  // namespace lray
