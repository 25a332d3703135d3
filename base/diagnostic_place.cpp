#include "base/diagnostic_place.h"

#include <fmt/format.h>

#include "base/excerpt.h"
#include "base/terminal_text.h"

namespace lray {

bool has_position(const Sources& sources, Span span) {
    const bool is_released = sources[span.source].text.size() == 0 && span.offset > 0;
    return !is_released;
}

std::string place_text(const Sources& sources, Span span) {
    std::string text = escape_for_terminal(sources[span.source].path, kMaxMessageSize);
    if (!has_position(sources, span)) return text;
    const Position position = sources.position(span);
    return text + fmt::format(":{}:{}", position.line, position.column);
}

std::optional<Extent> extent_of(const Sources& sources, Span span) {
    if (span.is_nowhere() || !has_position(sources, span)) return std::nullopt;
    return Extent{sources.position(span), sources.position({span.end(), span.source, 0})};
}

std::vector<Span> includes_of(const Sources& sources, Span span) {
    std::vector<Span> includes;
    if (span.is_nowhere()) return includes;
    for (SourceId id = span.source; !sources[id].included_from.is_nowhere();) {
        const Span from = sources[id].included_from;
        includes.push_back(from);
        if (from.source >= id) break;  // a file is included by one that was read before it
        id = from.source;
    }
    return includes;
}

}  // namespace lray
