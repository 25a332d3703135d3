#include "tests/parser/grammar_tables.h"

#include <fmt/format.h>

#include <limits>
#include <regex>
#include <sstream>

#include "base/assert.h"
#include "parser/blocks/schema.h"
#include "parser/builtins/builtins.h"
#include "parser/builtins/prelude.h"
#include "parser/reference.h"
#include "parser/syntax/token.h"
#include "parser/values/value.h"

namespace lray::parser {

namespace {

std::string in_words(const PropertySchema& property) {
    if (property.type != PropertyType::option) return std::string(type_name(property.type));
    std::string options;
    for (const std::string_view option : property.options) {
        options += fmt::format("{}`\"{}\"`", options.empty() ? "" : " ", option);
    }
    return options;
}

std::string in_words(const Range& range) {
    const bool has_max = range.max < std::numeric_limits<double>::infinity();
    const bool has_min = range.min > -std::numeric_limits<double>::infinity();
    if (!has_min && !has_max) return "";
    const std::string least =
        fmt::format("{} {}", range.min_is_open ? ">" : "≥", format_number(range.min));
    return has_max ? fmt::format("{}, ≤ {}", least, format_number(range.max)) : least;
}

std::string default_of(const PropertySchema& property) {
    if (property.is_required) return "required";
    return property.default_text.empty() ? "" : fmt::format("`{}`", property.default_text);
}

std::string names_of(std::span<const PropertySchema> properties, Form form) {
    std::string names;
    for (const PropertySchema& property : properties) {
        if (property.form != form) continue;
        names += fmt::format("{}`{}`", names.empty() ? "" : ", ", property.name);
    }
    return names;
}

std::string property_table(std::span<const PropertySchema> properties) {
    std::string text =
        "| property | value | default | range | meaning |\n"
        "|---|---|---|---|---|\n";
    for (const PropertySchema& property : properties) {
        text += fmt::format("| `{}` | {}{} | {} | {} | {} |\n", property.name, in_words(property),
                            property.takes_texture ? ", or texture" : "", default_of(property),
                            in_words(property.range), property.doc);
    }
    const std::string first = names_of(properties, Form::first);
    const std::string second = names_of(properties, Form::second);
    const std::string third = names_of(properties, Form::third);
    if (!third.empty()) {
        text += fmt::format("\nIt is written in one of three forms: {}; {}; or {}.\n", first,
                            second, third);
    } else if (!first.empty()) {
        text += fmt::format("\nIt is written in one of two forms: {}; or {}.\n", first, second);
    }
    return text;
}

// "`a`, `b`: vector; `about`: 3 numbers, optional"
std::string arguments_of(const Builtin& builtin) {
    std::string text;
    for (std::size_t i = 0; i < builtin.parameter_count(); ++i) {
        const Parameter& parameter = builtin.parameters[i];
        const bool is_last_of_kind = i + 1 == builtin.parameter_count() ||
                                     builtin.parameters[i + 1].type != parameter.type ||
                                     builtin.parameters[i + 1].is_optional != parameter.is_optional;
        text += fmt::format("`{}`", parameter.name);
        if (!is_last_of_kind) {
            text += ", ";
            continue;
        }
        text += fmt::format(": {}{}", type_name(parameter.type),
                            parameter.is_optional ? ", optional" : "");
        if (i + 1 < builtin.parameter_count()) text += "; ";
    }
    if (!builtin.is_variadic) return text;
    return fmt::format("{}{}more: {}", text, text.empty() ? "" : "; ",
                       type_name(builtin.rest_type));
}

std::string function_tables() {
    std::string text;
    for (const BuiltinFamily& family : builtin_families()) {
        text += fmt::format(
            "{}### {}\n\n"
            "| function | arguments | result |\n"
            "|---|---|---|\n",
            text.empty() ? "" : "\n", family.title);
        for (const Builtin& builtin : family.functions) {
            text += fmt::format("| `{}` | {} | {} |\n", builtin.name, arguments_of(builtin),
                                builtin.doc);
        }
    }
    return text;
}

/// Names in lines of at most 100 columns.
class WordList {
 public:
    void add(std::string_view name) {
        const std::string word = fmt::format("`{}`", name);
        if (line_.size() + 1 + word.size() > 100) end_line();
        line_ += (line_.empty() ? "" : " ") + word;
    }
    std::string text() {
        end_line();
        return text_;
    }

 private:
    void end_line() {
        if (!line_.empty()) text_ += line_ + "\n";
        line_.clear();
    }

    std::string text_;
    std::string line_;
};

std::string keywords(bool of_later) {
    WordList list;
    for (std::size_t i = 0; i < kKeywords.size(); ++i) {
        if (is_reserved_word(static_cast<TokenKind>(i)) == of_later) list.add(kKeywords[i]);
    }
    return list.text();
}

std::string colors() {
    WordList list;
    for (const Constant& constant : prelude_constants()) {
        if (constant.value.is(ValueKind::color)) list.add(constant.name);
    }
    return list.text();
}

std::string begin_mark(const std::string& name) {
    return fmt::format("<!-- begin {} -->\n", name);
}

std::string end_mark(const std::string& name) {
    return fmt::format("<!-- end {} -->\n", name);
}

std::string collapse_spaces(const std::string& text) {
    std::string result = std::regex_replace(text, std::regex("\\s+"), " ");
    result = std::regex_replace(result, std::regex("^ | $"), "");
    return result;
}

}  // namespace

std::vector<GeneratedText> generated_texts() {
    std::vector<GeneratedText> texts;
    texts.push_back({"keywords", keywords(false)});
    texts.push_back({"reserved words", keywords(true)});
    texts.push_back({"common properties", property_table(common_properties())});
    for (const BlockSchema& block : block_schemas()) {
        if (block.properties.empty()) continue;
        texts.push_back({std::string(block.name), property_table(block.properties)});
    }
    texts.push_back({"functions", function_tables()});
    texts.push_back({"colours", colors()});
    return texts;
}

std::string text_between_marks(const std::string& document, const std::string& name) {
    const std::string begin = begin_mark(name);
    const std::size_t from = document.find(begin);
    const std::size_t to = document.find(end_mark(name));
    const bool is_right = from != std::string::npos && to != std::string::npos && from < to &&
                          document.find(begin, from + 1) == std::string::npos;
    if (!is_right) return {};
    return document.substr(from + begin.size(), to - from - begin.size());
}

std::string with_text_between_marks(const std::string& document, const GeneratedText& generated) {
    const std::string begin = begin_mark(generated.name);
    const std::size_t from = document.find(begin) + begin.size();
    const std::size_t to = document.find(end_mark(generated.name));
    return document.substr(0, from) + generated.text + document.substr(to);
}

Productions productions_of(const std::string& ebnf) {
    const std::string text =
        std::regex_replace(ebnf, std::regex("\\(\\*[^*]*\\*\\)"), "");  // comments
    Productions productions;
    std::istringstream lines(text);
    std::string line;
    const std::regex begin("^([a-z_]+) += (.*)$");
    const std::regex joint(" ;  +");
    while (std::getline(lines, line)) {
        std::sregex_token_iterator parts(line.begin(), line.end(), joint, -1);
        for (; parts != std::sregex_token_iterator(); ++parts) {
            const std::string part = *parts;
            std::smatch match;
            if (std::regex_match(part, match, begin)) {
                productions.emplace_back(match[1], match[2]);
            } else if (!productions.empty()) {
                productions.back().second += " " + part;
            }
        }
    }
    for (auto& [name, body] : productions) {
        body = collapse_spaces(body);
        if (body.ends_with(" ;")) body.resize(body.size() - 2);
    }
    return productions;
}

std::string production_comments(const std::string& source) {
    std::istringstream lines(source);
    std::string line;
    std::string text;
    bool is_in_production = false;
    while (std::getline(lines, line)) {
        if (!line.starts_with("// ")) {
            is_in_production = false;
            continue;
        }
        const std::string comment = line.substr(3);
        is_in_production =
            is_in_production || std::regex_search(comment, std::regex("^[a-z_]+ += ["
                                                                      "a-z\"({A-Z\\[]"));
        if (is_in_production) text += comment + "\n";
    }
    return text;
}

}  // namespace lray::parser
