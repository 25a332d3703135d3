#include "base/diagnostics.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace lray {

Diagnostic& Diagnostics::error(Code code, Span span, std::string message) {
    return report(Severity::error, code, span, std::move(message));
}

Diagnostic& Diagnostics::warning(Code code, Span span, std::string message) {
    return report(Severity::warning, code, span, std::move(message));
}

Diagnostic& Diagnostics::report(Severity severity, Code code, Span span, std::string message) {
    if (severity == Severity::warning && levels_[code] == WarningLevel::allow) {
        dropped_ = Diagnostic{};
        return dropped_;
    }
    const bool is_kept = diagnostics_.size() < kMaxKept;
    has_limit_errors_ = has_limit_errors_ || (severity == Severity::error && is_limit(code));
    // Nowhere is no place: such reports are never merged by it.
    if (!span.is_nowhere()) {
        const Place place{severity == Severity::warning ? std::optional(code) : std::nullopt,
                          std::uint64_t{span.source} << 32 | span.offset};
        if (const auto known = by_place_.find(place); known != by_place_.end()) {
            Diagnostic& first = diagnostics_[known->second];
            if (first.code == code && first.message == message) ++first.count;
            dropped_ = Diagnostic{};
            return dropped_;
        }
        if (is_kept) by_place_.emplace(place, diagnostics_.size());
    }
    ++(severity == Severity::error ? error_count_ : warning_count_);
    const bool is_denied = severity == Severity::warning && levels_[code] == WarningLevel::deny;
    if (is_denied) ++denied_count_;
    if (!is_kept) {
        dropped_ = Diagnostic{};
        return dropped_;
    }
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = code;
    diagnostic.span = span;
    diagnostic.message = std::move(message);
    if (explain_) explain_(diagnostic);
    diagnostics_.push_back(std::move(diagnostic));
    return diagnostics_.back();
}

void Diagnostics::append(const Diagnostics& others) {
    for (const Diagnostic& other : others.diagnostics_) {
        Diagnostic& added = report(other.severity, other.code, other.span, other.message);
        if (&added != &dropped_) added = other;
    }
}

std::vector<const Diagnostic*> Diagnostics::sorted() const {
    std::vector<const Diagnostic*> result;
    result.reserve(diagnostics_.size());
    for (const Diagnostic& diagnostic : diagnostics_) result.push_back(&diagnostic);
    std::stable_sort(result.begin(), result.end(), [](const Diagnostic* a, const Diagnostic* b) {
        return std::tie(a->span.source, a->span.offset) < std::tie(b->span.source, b->span.offset);
    });
    return result;
}

std::vector<const Diagnostic*> Diagnostics::sorted(std::size_t max_count) const {
    std::vector<const Diagnostic*> result = sorted();
    if (max_count == 0) return result;
    std::size_t errors_left = max_count;
    std::size_t warnings_left = max_count;
    std::erase_if(result, [&](const Diagnostic* diagnostic) {
        std::size_t& left = diagnostic->severity == Severity::error ? errors_left : warnings_left;
        if (left == 0) return true;
        --left;
        return false;
    });
    return result;
}

}  // namespace lray
