#include "scene/formats/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>

namespace lray::scene::ply {

namespace {

// More than any tool writes; each row is looked at by its properties.
constexpr std::size_t kMaxElements = 100;
constexpr std::size_t kMaxProperties = 1000;

constexpr std::string_view kBlanks = " \t";

struct TypeName {
    std::string_view name;
    Type type;
};
constexpr std::array<TypeName, 16> kTypeNames = {{{"char", Type::int8},
                                                  {"uchar", Type::uint8},
                                                  {"short", Type::int16},
                                                  {"ushort", Type::uint16},
                                                  {"int", Type::int32},
                                                  {"uint", Type::uint32},
                                                  {"float", Type::float32},
                                                  {"double", Type::float64},
                                                  {"int8", Type::int8},
                                                  {"uint8", Type::uint8},
                                                  {"int16", Type::int16},
                                                  {"uint16", Type::uint16},
                                                  {"int32", Type::int32},
                                                  {"uint32", Type::uint32},
                                                  {"float32", Type::float32},
                                                  {"float64", Type::float64}}};

class HeaderReader {
 public:
    HeaderReader(const Text& text, Mistakes& mistakes) : rest_(text.view()), mistakes_(mistakes) {}

    std::optional<Header> read();

 private:
    std::optional<std::string_view> next_line();
    std::string_view next_word();
    bool read_line(std::string_view line);
    bool read_format();
    bool read_element(std::string_view line);
    bool read_property(std::string_view line);
    std::optional<Type> read_type(bool must_be_whole);
    bool end_line();
    bool have_rows_room();

    /// Tells a mistake at a word, or, of one that is missing, at its line.
    bool wrong(std::string_view word, std::string message) {
        mistakes_.in_text(Code::E0701, word.empty() ? line_ : word, std::move(message));
        return false;
    }

    std::string_view rest_;  // of the text
    std::string_view line_{};
    std::string_view words_{};  // of the line that are not read yet
    bool has_format_ = false;
    bool ends_with_cr_ = false;
    std::size_t property_count_ = 0;
    Header header_{};
    Mistakes& mistakes_;
};

std::optional<Header> HeaderReader::read() {
    const std::size_t first_end = rest_.find_first_of("\r\n");
    if (first_end == rest_.npos || rest_.substr(0, first_end) != "ply") {
        const std::size_t shown = std::min({first_end, rest_.size(), std::size_t{32}});
        mistakes_.in_text(Code::E0701, rest_.substr(0, shown),
                          "a PLY file begins with a line `ply`; this is none");
        return {};
    }
    ends_with_cr_ =
        rest_[first_end] == '\r' && (first_end + 1 == rest_.size() || rest_[first_end + 1] != '\n');
    (void)next_line();
    for (;;) {
        const std::string_view before = rest_;
        const std::optional<std::string_view> line = next_line();
        if (!line) {
            mistakes_.in_text(Code::E0701, before.substr(0, 0),
                              "the header does not end: no line `end_header` follows");
            return {};
        }
        line_ = words_ = *line;
        if (*line == "end_header") break;
        if (!read_line(*line)) return {};
    }
    header_.end_line = line_;
    header_.body = rest_.data();
    if (!has_format_) {
        (void)wrong(line_, "the header has no line like `format ascii 1.0`");
        return {};
    }
    if (!have_rows_room()) return {};
    return std::move(header_);
}

/// Takes a line without what ends it and blanks before that.
std::optional<std::string_view> HeaderReader::next_line() {
    const std::size_t end = rest_.find(ends_with_cr_ ? '\r' : '\n');
    if (end == rest_.npos) return {};
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    const std::size_t last = line.find_last_not_of(" \t\r");
    return line.substr(0, last == line.npos ? 0 : last + 1);
}

std::string_view HeaderReader::next_word() {
    words_.remove_prefix(std::min(words_.find_first_not_of(kBlanks), words_.size()));
    const std::string_view word = words_.substr(0, words_.find_first_of(kBlanks));
    words_.remove_prefix(word.size());
    return word;
}

bool HeaderReader::read_line(std::string_view line) {
    const std::string_view keyword = next_word();
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
    if (keyword == "format") return read_format();
    if (keyword == "element") return read_element(line);
    if (keyword == "property") return read_property(line);
    return wrong(keyword,
                 fmt::format("expected `format`, `element`, `property`, `comment` or `end_header`, "
                             "found {}",
                             quoted(keyword)));
}

/// format CODING 1.0
bool HeaderReader::read_format() {
    const std::string_view coding = next_word();
    if (has_format_) return wrong(coding, "the format is told twice");
    has_format_ = true;
    if (coding == "ascii") {
        header_.coding = Coding::ascii;
    } else if (coding == "binary_little_endian") {
        header_.coding = Coding::little_endian;
    } else if (coding == "binary_big_endian") {
        header_.coding = Coding::big_endian;
    } else {
        return wrong(coding, fmt::format("the format is `ascii`, `binary_little_endian` or "
                                         "`binary_big_endian`, not {}",
                                         quoted(coding)));
    }
    const std::string_view version = next_word();
    if (version != "1.0") {
        mistakes_.in_text(Code::E0705, version.empty() ? line_ : version,
                          fmt::format("PLY of version 1.0 is read, this is {}", quoted(version)));
        return false;
    }
    return end_line();
}

/// element NAME COUNT
bool HeaderReader::read_element(std::string_view line) {
    const std::string_view name = next_word();
    if (name.empty()) return wrong({}, "expected a line like `element vertex 3`");
    const auto is_same = [&](const Element& other) { return other.name == name; };
    if (std::any_of(header_.elements.begin(), header_.elements.end(), is_same)) {
        return wrong(name, fmt::format("there is an element {} already", quoted(name)));
    }
    if (header_.elements.size() == kMaxElements) {
        mistakes_.in_text(
            Code::E0705, name,
            fmt::format("a file can have {} elements; this is one more", kMaxElements));
        return false;
    }
    const std::string_view count = next_word();
    Element element{name, 0, {}, line};
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error == std::errc::result_out_of_range) {
        return wrong(count, fmt::format("{} rows are more than any file holds", quoted(count)));
    }
    if (count.empty() || error != std::errc{} || end != count.data() + count.size()) {
        return wrong(count, fmt::format("expected how many {} there are, found {}", quoted(name),
                                        quoted(count)));
    }
    header_.elements.push_back(std::move(element));
    return end_line();
}

/// property TYPE NAME
/// property list TYPE TYPE NAME
bool HeaderReader::read_property(std::string_view line) {
    if (header_.elements.empty()) return wrong(line, "this property comes before any element");
    Property property;
    property.line = line;
    const std::string_view words = words_;
    property.is_list = next_word() == "list";
    if (property.is_list) {
        const std::optional<Type> count_type = read_type(true);
        if (!count_type) return false;
        property.count_type = *count_type;
    } else {
        words_ = words;
    }
    const std::optional<Type> type = read_type(false);
    if (!type) return false;
    property.type = *type;
    property.name = next_word();
    if (property.name.empty()) return wrong({}, "expected a line like `property float x`");
    std::vector<Property>& properties = header_.elements.back().properties;
    const auto is_same = [&](const Property& other) { return other.name == property.name; };
    if (std::any_of(properties.begin(), properties.end(), is_same)) {
        return wrong(property.name,
                     fmt::format("there is a property {} already", quoted(property.name)));
    }
    if (property_count_++ == kMaxProperties) {
        mistakes_.in_text(
            Code::E0705, property.name,
            fmt::format("a file can have {} properties; this is one more", kMaxProperties));
        return false;
    }
    properties.push_back(property);
    return end_line();
}

std::optional<Type> HeaderReader::read_type(bool must_be_whole) {
    const std::string_view word = next_word();
    const auto* const known = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                           [&](const TypeName& type) { return type.name == word; });
    if (known == kTypeNames.end()) {
        (void)wrong(word,
                    fmt::format("expected a type like `float` or `uchar`, found {}", quoted(word)));
        return {};
    }
    if (must_be_whole && !is_whole(known->type)) {
        (void)wrong(word,
                    fmt::format("how long a list is, is a whole number, not a {}", quoted(word)));
        return {};
    }
    return known->type;
}

bool HeaderReader::end_line() {
    const std::string_view word = next_word();
    return word.empty() ||
           wrong(word, fmt::format("expected the line to end, found {}", quoted(word)));
}

/// Each row takes some bytes, so the counts are bounded before anything is reserved for them.
bool HeaderReader::have_rows_room() {
    std::uint64_t left = rest_.size();
    if (header_.coding == Coding::ascii) ++left;  // nothing need end the last value
    for (const Element& element : header_.elements) {
        const std::uint64_t row_size = element.least_row_size(header_.coding);
        if (row_size == 0) continue;
        if (element.count > left / row_size) {
            return wrong(element.line,
                         fmt::format("{} rows of {} take {} bytes or more each, but the file has "
                                     "only {} for them",
                                     element.count, quoted(element.name), row_size, left));
        }
        left -= element.count * row_size;
    }
    return true;
}

}  // namespace

std::size_t Element::least_row_size(Coding coding) const {
    if (coding == Coding::ascii) return 2 * properties.size();
    std::size_t size = 0;
    for (const Property& property : properties) {
        size += size_of(property.is_list ? property.count_type : property.type);
    }
    return size;
}

std::optional<Header> read_header(const Text& text, Mistakes& mistakes) {
    return HeaderReader(text, mistakes).read();
}

}  // namespace lray::scene::ply
