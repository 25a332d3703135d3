#include "base/diagnostic_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostic_place.h"
#include "base/excerpt.h"
#include "base/terminal_text.h"

namespace lray {
namespace {

// ANSI select graphic rendition. Meaning never by colour alone: the words stand beside it.
constexpr Palette kErrorColors{"\x1b[1;31m", "\x1b[1;34m", "\x1b[1;34m", "\x1b[1m", "\x1b[0m"};
constexpr Palette kWarningColors{"\x1b[1;33m", "\x1b[1;34m", "\x1b[1;34m", "\x1b[1m", "\x1b[0m"};

bool has_excerpt(const Sources& sources, Span span) {
    return !span.is_nowhere() && sources[span.source].text.size() > 0;
}

/// Returns "in c.lrs, included from b.lrs:1:1, included from a.lrs:2:1", the middle of a long
/// chain folded; empty for the main file.
std::string include_chain(const Sources& sources, Span span) {
    constexpr std::size_t kMaxShown = 5;
    const std::vector<Span> includes = includes_of(sources, span);
    if (includes.empty()) return {};
    std::string text = "in " + escape_for_terminal(sources[span.source].path, kMaxMessageSize);
    for (std::size_t i = 0; i < includes.size(); ++i) {
        const bool is_folded = includes.size() > kMaxShown && i == kMaxShown - 2;
        if (is_folded) {
            const std::size_t folded_count = includes.size() - (kMaxShown - 1);
            text += fmt::format(", ... ({} more)", folded_count);
            i += folded_count;
        }
        text += ", included from " + place_text(sources, includes[i]);
    }
    return text;
}

/// Returns "in flake (flake.lrs:4:1)" for each running call, the innermost first, the middle of
/// many folded.
std::vector<std::string> call_lines(const Sources& sources, std::span<const CallSite> calls) {
    constexpr std::size_t kMaxShown = 6;
    constexpr std::size_t kLastShown = 3;
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < calls.size(); ++i) {
        // In place of a single line another one would gain nothing.
        const bool is_folded = calls.size() > kMaxShown + 1 && i == kMaxShown - kLastShown;
        if (is_folded) {
            lines.push_back(fmt::format("... {} more calls ...", calls.size() - kMaxShown));
            i = calls.size() - kLastShown;
        }
        const CallSite& call = calls[i];
        lines.push_back("in " + escape_for_terminal(call.name, kMaxMessageSize));
        if (!call.place.is_nowhere()) lines.back() += " (" + place_text(sources, call.place) + ")";
    }
    return lines;
}

/// The marks of a diagnostic by source, that of the diagnostic itself first.
struct MarkGroup {
    SourceId source = kNoSource;
    std::vector<Mark> marks{};
};

std::vector<MarkGroup> group_marks(const Diagnostic& diagnostic, const Sources& sources) {
    std::vector<MarkGroup> groups;
    const auto add = [&](Mark mark) {
        if (!has_excerpt(sources, mark.span)) return;
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const MarkGroup& g) {
            return g.source == mark.span.source;
        });
        if (group != groups.end()) {
            group->marks.push_back(std::move(mark));
        } else {
            groups.push_back({mark.span.source, {std::move(mark)}});
        }
    };
    add({diagnostic.span, diagnostic.hint, true});
    for (const Label& label : diagnostic.labels) add({label.span, label.message, false});
    return groups;
}

std::string format_diagnostic(const Diagnostic& diagnostic, const Sources& sources, bool color) {
    const bool is_error = diagnostic.severity == Severity::error;
    Palette palette;
    if (color) palette = is_error ? kErrorColors : kWarningColors;
    const bool is_nowhere = diagnostic.span.is_nowhere();

    std::string result = fmt::format(
        "{}{}:{} {}{}[{}]:{} {}{}", palette.strong,
        is_nowhere ? std::string("lray") : place_text(sources, diagnostic.span), palette.reset,
        palette.primary, is_error ? "error" : "warning", code_info(diagnostic.code).id,
        palette.reset, palette.strong, escape_for_terminal(diagnostic.message, kMaxMessageSize));
    if (diagnostic.count > 1) result += fmt::format(" (occurred {} times)", diagnostic.count);
    result += fmt::format("{}\n", palette.reset);

    const std::vector<MarkGroup> groups = group_marks(diagnostic, sources);
    std::size_t width = 1;
    for (const MarkGroup& group : groups) {
        width = std::max(width, line_number_width(sources, group.marks));
    }
    for (const MarkGroup& group : groups) {
        if (group.source != diagnostic.span.source) {
            result += fmt::format("{:>{}}{}:::{} {}\n", "", width + 1, palette.gutter,
                                  palette.reset, place_text(sources, group.marks.front().span));
        }
        result += format_excerpt(sources, group.marks, width, palette);
    }

    const auto add_line = [&](std::string_view title, std::string_view escaped) {
        result += fmt::format("{:>{}}{}={} {}{}\n", "", width + 1, palette.gutter, palette.reset,
                              title, escaped);
    };
    const auto add_text = [&](std::string_view title, std::string_view text) {
        add_line(title, escape_for_terminal(text, kMaxMessageSize));
    };
    if (!has_excerpt(sources, diagnostic.span) && !diagnostic.hint.empty()) {
        add_text("", diagnostic.hint);
    }
    for (const Label& label : diagnostic.labels) {
        if (has_excerpt(sources, label.span)) continue;
        add_line("", escape_for_terminal(label.message, kMaxMessageSize) +
                         (label.span.is_nowhere() ? "" : ": " + place_text(sources, label.span)));
    }
    for (const std::string& line : call_lines(sources, diagnostic.calls)) add_line("", line);
    const std::string chain = include_chain(sources, diagnostic.span);
    if (!chain.empty()) add_line("", chain);
    for (const std::string& note : diagnostic.notes) add_text("note: ", note);
    for (const std::string& help : diagnostic.helps) add_text("help: ", help);
    return result;
}

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::string format_diagnostics(const Diagnostics& diagnostics, const Sources& sources,
                               const PrintOptions& options) {
    std::string result;
    const std::size_t kept_count = diagnostics.sorted().size();
    const std::vector<const Diagnostic*> shown = diagnostics.sorted(options.max_errors);
    for (const Diagnostic* diagnostic : shown) {
        result += format_diagnostic(*diagnostic, sources, options.color);
        result += '\n';
    }
    const std::size_t all_count = diagnostics.error_count() + diagnostics.warning_count();
    if (all_count > shown.size()) {
        result += fmt::format("... and {} more", all_count - shown.size());
        // What was not kept cannot be shown by any option.
        if (kept_count > shown.size()) result += " (`--max-errors 0` shows all)";
        result += '\n';
    }
    return result;
}

std::string summary(const Diagnostics& diagnostics) {
    std::string text;
    if (diagnostics.error_count() > 0) text += counted(diagnostics.error_count(), "error");
    if (diagnostics.error_count() > 0 && diagnostics.warning_count() > 0) text += ", ";
    if (diagnostics.warning_count() > 0) text += counted(diagnostics.warning_count(), "warning");
    return text;
}

}  // namespace lray
