// Reads JSON as RFC 8259 has it, strictly: to see what others would make of our output.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lray::test {

enum class JsonKind { null, boolean, number, string, array, object };

struct Json {
    JsonKind kind = JsonKind::null;
    double number = 0.0;  // of a boolean 0 or 1
    std::string string{};
    std::vector<Json> elements{};
    std::map<std::string, Json> members{};

    bool has(const std::string& name) const { return members.contains(name); }
    bool is_null() const { return kind == JsonKind::null; }

    /// Throws if there is no such member or element.
    const Json& operator[](const std::string& name) const { return members.at(name); }
    const Json& operator[](std::size_t index) const { return elements.at(index); }
};

/// Throws std::runtime_error for what is no JSON: trailing commas, doubled names, control
/// characters in strings, bytes that are not UTF-8, anything behind the value but white space.
Json read_json(std::string_view text);

}  // namespace lray::test
