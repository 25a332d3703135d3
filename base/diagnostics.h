// Diagnostics: what is told to the user about their input. Collected here, printed by
// base/diagnostic_printer.h; codes are explained in base/diagnostic_codes.h.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic_codes.h"
#include "base/source.h"
#include "base/warning_levels.h"

namespace lray {

enum class Severity : std::uint8_t { error, warning };

/// Another place that belongs to a diagnostic: "opened here", "first set here".
struct Label {
    Span span{};
    std::string message{};
};

/// A call that was running: what was called, and where.
struct CallSite {
    Span place{};
    std::string name{};
};

/// What mends it: this text in place of the span.
struct Fix {
    Span span{};
    std::string replacement{};
};

/// One mistake. Messages are lower case, without a full stop, and say what was found, what was
/// expected, and the fix when it is known. Every text is one line.
struct Diagnostic {
    Severity severity = Severity::error;
    Code code{};
    Span span{};
    std::string message{};
    std::string hint{};  // printed beside the carets: "did you mean `radius`?"
    std::vector<Label> labels{};
    std::vector<std::string> notes{};
    std::vector<std::string> helps{};
    std::vector<CallSite> calls{};  // that led here, the innermost first
    std::optional<Fix> fix{};       // only when it is sure
    std::uint32_t count = 1;        // how often the same mistake occurred in this place

    Diagnostic& with_hint(std::string text) {
        hint = std::move(text);
        return *this;
    }
    Diagnostic& with_label(Span place, std::string text) {
        labels.push_back({place, std::move(text)});
        return *this;
    }
    Diagnostic& with_note(std::string text) {
        notes.push_back(std::move(text));
        return *this;
    }
    Diagnostic& with_help(std::string text) {
        helps.push_back(std::move(text));
        return *this;
    }
    Diagnostic& with_call(Span place, std::string name) {
        calls.push_back({place, std::move(name)});
        return *this;
    }
    /// A span so long that its end is not known is not replaced.
    Diagnostic& with_fix(Span place, std::string replacement) {
        const bool is_whole = !place.is_nowhere() && place.length < Span::kMaxLength;
        if (is_whole) fix = Fix{place, std::move(replacement)};
        return *this;
    }
};

/// Collects the diagnostics of a run. One error per place: a second error that begins where one
/// was already reported is dropped, the same one again is counted; likewise one warning of each
/// code per place. At most kMaxKept are kept, so that a hostile file cannot fill the memory with
/// its mistakes; all are counted.
class Diagnostics {
 public:
    static constexpr std::size_t kMaxKept = 10000;
    static constexpr std::size_t kMaxHinted = 100;

    Diagnostics() = default;
    explicit Diagnostics(const WarningLevels& levels) : levels_(levels) {}

    /// The returned diagnostic takes hints, labels, notes, helps, calls and a fix; the reference is
    /// valid until the next report. A warning that is allowed is dropped.
    Diagnostic& error(Code code, Span span, std::string message);
    Diagnostic& warning(Code code, Span span, std::string message);

    /// False if a warning of this code is dropped: what only finds it need not be done.
    bool tells(Code warning) const { return levels_[warning] != WarningLevel::allow; }

    /// Says of everything that is reported from now on where it comes from: the calls that led
    /// there. An empty function ends it.
    void explain_with(std::function<void(Diagnostic&)> explain) { explain_ = std::move(explain); }

    /// Adds all of another collection's.
    void append(const Diagnostics& others);

    std::size_t error_count() const { return error_count_; }
    std::size_t warning_count() const { return warning_count_; }
    bool has_errors() const { return error_count_ > 0; }

    /// Of the warnings, those that are denied.
    std::size_t denied_count() const { return denied_count_; }

    /// False once there are so many errors that nobody reads the hints of more: a search for a name
    /// that was meant looks at all names there are.
    bool takes_hints() const { return error_count_ <= kMaxHinted; }

    /// True if an error was a limit or memory (exit code 3).
    bool has_limit_errors() const { return has_limit_errors_; }

    /// In the order of printing: by source, then by position; a note stays with its error.
    std::vector<const Diagnostic*> sorted() const;

    /// The same, but at most `max_count` errors and as many warnings, so that warnings never crowd
    /// out an error; 0: all.
    std::vector<const Diagnostic*> sorted(std::size_t max_count) const;

 private:
    Diagnostic& report(Severity severity, Code code, Span span, std::string message);

    WarningLevels levels_;
    std::function<void(Diagnostic&)> explain_;
    std::vector<Diagnostic> diagnostics_;
    using Place = std::pair<std::optional<Code>, std::uint64_t>;  // the code of a warning
    std::map<Place, std::size_t> by_place_;                       // of those kept
    Diagnostic dropped_;
    std::size_t error_count_ = 0;
    std::size_t warning_count_ = 0;
    std::size_t denied_count_ = 0;
    bool has_limit_errors_ = false;
};

}  // namespace lray
