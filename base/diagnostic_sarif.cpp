#include "base/diagnostic_sarif.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostic_place.h"
#include "base/json_writer.h"

namespace lray {
namespace {

constexpr const char* kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// Writes {"text": text}, a message.
void write_message(JsonWriter& json, std::string_view name, std::string_view text) {
    json.key(name).begin_object().member("text", text).end_object();
}

/// Writes the members of a region; columns only where the text is at hand.
void write_region(JsonWriter& json, std::string_view name, const Sources& sources, Span span) {
    json.key(name).begin_object();
    if (const auto extent = extent_of(sources, span)) {
        json.member("startLine", extent->begin.line)
            .member("startColumn", extent->begin.column)
            .member("endLine", extent->end.line)
            .member("endColumn", extent->end.column);
    }
    json.member("byteOffset", span.offset).member("byteLength", span.length).end_object();
}

void write_artifact(JsonWriter& json, const Sources& sources, Span span) {
    json.key("artifactLocation")
        .begin_object()
        .member("uri", uri_of(sources[span.source].path))
        .end_object();
}

void write_physical_location(JsonWriter& json, const Sources& sources, Span span) {
    json.key("physicalLocation").begin_object();
    write_artifact(json, sources, span);
    write_region(json, "region", sources, span);
    json.end_object();
}

/// Message and everything that has no place of its own, a line each.
std::string whole_message(const Diagnostic& diagnostic) {
    std::string text = diagnostic.message;
    if (!diagnostic.hint.empty()) text += "\n" + diagnostic.hint;
    for (const Label& label : diagnostic.labels) {
        if (label.span.is_nowhere()) text += "\n" + label.message;
    }
    for (const std::string& note : diagnostic.notes) text += "\nnote: " + note;
    for (const std::string& help : diagnostic.helps) text += "\nhelp: " + help;
    return text;
}

void write_related_locations(JsonWriter& json, const Diagnostic& diagnostic,
                             const Sources& sources) {
    std::vector<Label> related;
    for (const Label& label : diagnostic.labels) {
        if (!label.span.is_nowhere()) related.push_back(label);
    }
    for (const Span include : includes_of(sources, diagnostic.span)) {
        related.push_back({include, "included from here"});
    }
    if (related.empty()) return;
    json.key("relatedLocations").begin_array();
    for (std::size_t i = 0; i < related.size(); ++i) {
        json.begin_object().member("id", i);
        write_message(json, "message", related[i].message);
        write_physical_location(json, sources, related[i].span);
        json.end_object();
    }
    json.end_array();
}

void write_stack(JsonWriter& json, const Diagnostic& diagnostic, const Sources& sources) {
    if (diagnostic.calls.empty()) return;
    json.key("stacks").begin_array().begin_object();
    write_message(json, "message", "the calls that led here");
    json.key("frames").begin_array();
    for (const CallSite& call : diagnostic.calls) {
        json.begin_object().key("location").begin_object();
        write_message(json, "message", "in " + call.name);
        if (!call.place.is_nowhere()) write_physical_location(json, sources, call.place);
        json.end_object().end_object();
    }
    json.end_array().end_object().end_array();
}

void write_fixes(JsonWriter& json, const Diagnostic& diagnostic, const Sources& sources) {
    if (!diagnostic.fix) return;
    const auto& [span, replacement] = *diagnostic.fix;
    json.key("fixes").begin_array().begin_object();
    write_message(json, "description", fmt::format("write `{}`", replacement));
    json.key("artifactChanges").begin_array().begin_object();
    write_artifact(json, sources, span);
    json.key("replacements").begin_array().begin_object();
    write_region(json, "deletedRegion", sources, span);
    write_message(json, "insertedContent", replacement);
    json.end_object().end_array().end_object().end_array().end_object().end_array();
}

void write_result(JsonWriter& json, const Diagnostic& diagnostic, const Sources& sources,
                  std::size_t rule_index) {
    json.begin_object()
        .member("ruleId", code_info(diagnostic.code).id)
        .member("ruleIndex", rule_index)
        .member("level", diagnostic.severity == Severity::error ? "error" : "warning");
    write_message(json, "message", whole_message(diagnostic));
    json.key("locations").begin_array();
    if (!diagnostic.span.is_nowhere()) {
        json.begin_object();
        write_physical_location(json, sources, diagnostic.span);
        json.end_object();
    }
    json.end_array();
    json.member("occurrenceCount", diagnostic.count);
    write_related_locations(json, diagnostic, sources);
    write_stack(json, diagnostic, sources);
    write_fixes(json, diagnostic, sources);
    json.end_object();
}

void write_rule(JsonWriter& json, const CodeInfo& info) {
    json.begin_object().member("id", info.id).member("name", slug(info));
    write_message(json, "shortDescription", info.title);
    write_message(json, "fullDescription", info.explanation);
    write_message(json, "help",
                  fmt::format("{}\n\nWrong:\n\n{}\n\nRight:\n\n{}\n", info.explanation, info.wrong,
                              info.right));
    json.key("defaultConfiguration")
        .begin_object()
        .member("level", is_warning(info) ? "warning" : "error")
        .end_object()
        .end_object();
}

}  // namespace

std::string format_sarif(const Diagnostics& diagnostics, const Sources& sources,
                         std::size_t max_errors) {
    const std::vector<const Diagnostic*> shown = diagnostics.sorted(max_errors);
    std::map<Code, std::size_t> rules;  // of the codes that occur
    for (const Diagnostic* diagnostic : shown) rules.emplace(diagnostic->code, 0);
    std::size_t next_index = 0;
    for (auto& [code, index] : rules) index = next_index++;

    JsonWriter json;
    json.begin_object().member("$schema", kSchema).member("version", "2.1.0");
    json.key("runs").begin_array().begin_object();
    json.key("tool").begin_object().key("driver").begin_object();
    json.member("name", "lray").member("version", LRAY_VERSION).key("rules").begin_array();
    for (const auto& [code, index] : rules) write_rule(json, code_info(code));
    json.end_array().end_object().end_object();
    json.member("columnKind", "unicodeCodePoints");
    json.key("results").begin_array();
    for (const Diagnostic* diagnostic : shown) {
        write_result(json, *diagnostic, sources, rules.at(diagnostic->code));
    }
    json.end_array().end_object().end_array().end_object();
    return json.take() + "\n";
}

std::string uri_of(std::string_view path) {
    constexpr std::string_view kUnreserved =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        if (kUnreserved.find(c) != kUnreserved.npos) {
            uri += c;
        } else {
            uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return uri;
}

}  // namespace lray
