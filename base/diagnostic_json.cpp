#include "base/diagnostic_json.h"

#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostic_place.h"
#include "base/json_writer.h"

namespace lray {
namespace {

/// The members that tell a place; null where there is none.
void write_place(JsonWriter& json, const Sources& sources, Span span) {
    const std::optional<Extent> extent = extent_of(sources, span);
    const auto number = [&](std::string_view name, bool is_known, std::uint64_t value) {
        json.key(name);
        is_known ? json.number(value) : json.null();
    };
    json.key("file");
    span.is_nowhere() ? json.null() : json.string(sources[span.source].path);
    number("line", extent.has_value(), extent ? extent->begin.line : 0);
    number("column", extent.has_value(), extent ? extent->begin.column : 0);
    number("end_line", extent.has_value(), extent ? extent->end.line : 0);
    number("end_column", extent.has_value(), extent ? extent->end.column : 0);
    number("offset", !span.is_nowhere(), span.offset);
    number("length", !span.is_nowhere(), span.length);
}

void write_texts(JsonWriter& json, std::string_view name, const std::vector<std::string>& texts) {
    json.key(name).begin_array();
    for (const std::string& text : texts) json.string(text);
    json.end_array();
}

void write_fix(JsonWriter& json, const Sources& sources, const std::optional<Fix>& fix) {
    json.key("fix");
    if (!fix) {
        json.null();
        return;
    }
    json.begin_object();
    write_place(json, sources, fix->span);
    json.member("replacement", fix->replacement).end_object();
}

void write_diagnostic(JsonWriter& json, const Diagnostic& diagnostic, const Sources& sources) {
    const bool is_error = diagnostic.severity == Severity::error;
    json.begin_object()
        .member("code", code_info(diagnostic.code).id)
        .member("severity", is_error ? "error" : "warning")
        .member("message", diagnostic.message)
        .member("hint", diagnostic.hint);
    write_place(json, sources, diagnostic.span);
    json.member("count", diagnostic.count);
    json.key("labels").begin_array();
    for (const Label& label : diagnostic.labels) {
        json.begin_object();
        write_place(json, sources, label.span);
        json.member("message", label.message).end_object();
    }
    json.end_array();
    write_texts(json, "notes", diagnostic.notes);
    write_texts(json, "helps", diagnostic.helps);
    json.key("calls").begin_array();
    for (const CallSite& call : diagnostic.calls) {
        json.begin_object();
        write_place(json, sources, call.place);
        json.member("name", call.name).end_object();
    }
    json.end_array();
    json.key("included_from").begin_array();
    for (const Span include : includes_of(sources, diagnostic.span)) {
        json.begin_object();
        write_place(json, sources, include);
        json.end_object();
    }
    json.end_array();
    write_fix(json, sources, diagnostic.fix);
    json.end_object();
}

}  // namespace

std::string format_json(const Diagnostics& diagnostics, const Sources& sources,
                        std::size_t max_errors) {
    std::string lines;
    for (const Diagnostic* diagnostic : diagnostics.sorted(max_errors)) {
        JsonWriter json;
        write_diagnostic(json, *diagnostic, sources);
        lines += json.take();
        lines += '\n';
    }
    return lines;
}

}  // namespace lray
