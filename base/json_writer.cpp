#include "base/json_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/assert.h"
#include "base/utf8.h"

namespace lray {
namespace {

/// Returns a UTF-16 code unit as JSON escapes it.
std::string escaped_unit(std::uint32_t unit) {
    return fmt::format("\\u{:04x}", unit);
}

std::string escaped(std::uint32_t code_point) {
    switch (code_point) {
        case '"':
            return "\\\"";
        case '\\':
            return "\\\\";
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return escaped_unit(code_point);
    }
}

/// What JSON demands, DEL and the C1 controls, and the line separators that JavaScript once did not
/// take in strings.
bool needs_escape(std::uint32_t c) {
    return c < 0x20 || c == '"' || c == '\\' || (c >= 0x7f && c < 0xa0) || c == 0x2028 ||
           c == 0x2029;
}

}  // namespace

JsonWriter& JsonWriter::begin_object() {
    open('{', '}');
    return *this;
}

JsonWriter& JsonWriter::end_object() {
    close('}');
    return *this;
}

JsonWriter& JsonWriter::begin_array() {
    open('[', ']');
    return *this;
}

JsonWriter& JsonWriter::end_array() {
    close(']');
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    LRAY_ASSERT(!levels_.empty() && levels_.back().closer == '}' && !levels_.back().has_key);
    if (std::exchange(levels_.back().has_elements, true)) text_ += ',';
    write_string(name);
    text_ += ':';
    levels_.back().has_key = true;
    return *this;
}

JsonWriter& JsonWriter::string(std::string_view text) {
    begin_value();
    write_string(text);
    return *this;
}

JsonWriter& JsonWriter::number(std::uint64_t number) {
    begin_value();
    text_ += fmt::format("{}", number);
    return *this;
}

JsonWriter& JsonWriter::decimal(double number) {
    if (!std::isfinite(number)) return null();
    begin_value();
    text_ += fmt::format("{}", number);
    return *this;
}

JsonWriter& JsonWriter::null() {
    begin_value();
    text_ += "null";
    return *this;
}

std::string JsonWriter::take() {
    LRAY_ASSERT(levels_.empty());
    return std::exchange(text_, {});
}

void JsonWriter::begin_value() {
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (level.closer == '}') {
        LRAY_ASSERT(level.has_key);
        level.has_key = false;
    } else if (std::exchange(level.has_elements, true)) {
        text_ += ',';
    }
}

void JsonWriter::open(char opener, char closer) {
    begin_value();
    text_ += opener;
    levels_.push_back({closer});
}

void JsonWriter::close(char closer) {
    LRAY_ASSERT(!levels_.empty() && levels_.back().closer == closer && !levels_.back().has_key);
    levels_.pop_back();
    text_ += closer;
}

void JsonWriter::write_string(std::string_view text) {
    text_ += '"';
    while (!text.empty()) {
        const DecodedCodePoint decoded = decode_utf8(text);
        if (decoded.size == 0) {
            text_ += "\xef\xbf\xbd";
            text.remove_prefix(1);
            continue;
        }
        if (needs_escape(decoded.code_point)) {
            text_ += escaped(decoded.code_point);
        } else {
            text_ += text.substr(0, decoded.size);
        }
        text.remove_prefix(decoded.size);
    }
    text_ += '"';
}

}  // namespace lray
