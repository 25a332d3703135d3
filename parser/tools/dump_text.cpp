#include "parser/tools/dump_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/angle.h"

namespace lray::parser {

namespace {

/// Columns of a line that are filled; the formatter has a few more.
constexpr std::size_t kWidth = 96;

std::string rows_of(const Transform& transform) {
    std::string text = "[";
    for (int row = 0; row < 3; ++row) {
        text += row == 0 ? "[" : ", [";
        for (int column = 0; column < 3; ++column) {
            append_exact(text, transform.linear()[column][row]);
            text += ", ";
        }
        append_exact(text, transform.offset()[row]);
        text += "]";
    }
    return text + "]";
}

/// True if a `translate` step alone makes the same bits.
bool is_translation(const Transform& transform) {
    if (!transform.is_similarity() || transform.similarity_scale() != 1.0) return false;
    for (int column = 0; column < 3; ++column) {
        const double offset = transform.offset()[column];
        if (offset == 0.0 && std::signbit(offset)) return false;
        for (int row = 0; row < 3; ++row) {
            const double entry = transform.linear()[column][row];
            if (entry != (row == column ? 1.0 : 0.0) || std::signbit(entry)) return false;
        }
    }
    return true;
}

/// Appends a value, its outer brackets opened up where it is wider than a line.
void append_value(std::string& text, std::string_view value, std::size_t column,
                  std::size_t indent) {
    const std::size_t first = value.find_first_of("[(\"");
    const bool has_list = first != value.npos && value[first] != '"';
    if (column + value.size() <= kWidth || !has_list) {
        text += value;
        return;
    }
    std::size_t open = first;
    while (value[open + 1] == '[' && value[open] == '(') ++open;  // `matrix([`
    const std::size_t depth_of_list = open - first + 1;
    text += value.substr(0, open + 1);
    std::size_t depth = 0;
    std::size_t begin = open + 1;
    const auto append_element = [&](std::size_t end) {
        text += '\n';
        text.append(indent + 2, ' ');
        append_value(text, value.substr(begin, end - begin), indent + 2, indent + 2);
    };
    bool is_string = false;
    for (std::size_t i = begin; i < value.size(); ++i) {
        const char c = value[i];
        if (is_string) {
            if (c == '\\') ++i;
            if (c == '"') is_string = false;
        } else if (c == '"') {
            is_string = true;
        } else if (c == '[' || c == '(') {
            ++depth;
        } else if ((c == ']' || c == ')') && depth > 0) {
            --depth;
        } else if (c == ']' || c == ')') {
            append_element(i);
            text += '\n';
            text.append(indent, ' ');
            text += value.substr(i, depth_of_list);
            text += value.substr(i + depth_of_list);
            return;
        } else if (c == ',' && depth == 0) {
            append_element(i);
            text += ',';
            begin = i + 2;
        }
    }
}

}  // namespace

void append_exact(std::string& text, double number) {
    fmt::format_to(std::back_inserter(text), "{}", number);
}

void append_exact(std::string& text, float number) {
    if (std::isinf(number)) {
        text += number > 0.0f ? "1e300" : "-1e300";
        return;
    }
    const std::size_t begin = text.size();
    fmt::format_to(std::back_inserter(text), "{}", number);
    // It is read as a double, and rounded once more.
    double read = 0.0;
    std::from_chars(text.data() + begin, text.data() + text.size(), read);
    if (static_cast<float>(read) == number) return;
    text.resize(begin);
    append_exact(text, static_cast<double>(number));
}

std::string exact(double number) {
    std::string text;
    append_exact(text, number);
    return text;
}

std::string exact(float number) {
    std::string text;
    append_exact(text, number);
    return text;
}

std::string exact(DVec3 v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

std::string exact(scene::Resolution size) {
    return fmt::format("[{}, {}]", size.width, size.height);
}

std::string exact_color(Color color) {
    return fmt::format("rgb({}, {}, {})", exact(color.x), exact(color.y), exact(color.z));
}

std::string exact_angle(double angle) {
    const double about = degrees(angle);
    for (const int digits : {15, 16}) {
        const std::string text = fmt::format("{:.{}g}", about, digits);
        double read = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), read);
        if (radians(read) == angle) return exact(read);
    }
    // Some degrees were read as these radians, and they are not far.
    double below = about;
    double above = about;
    constexpr int kMostSteps = 8;  // two roundings each way are fewer
    for (int i = 0; i < kMostSteps; ++i) {
        if (radians(below) == angle) return exact(below);
        if (radians(above) == angle) return exact(above);
        below = std::nextafter(below, 0.0);
        above = std::nextafter(above, std::numeric_limits<double>::infinity());
    }
    return exact(about);
}

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (c == '\n') {
            result += "\\n";
        } else if (c == '\t') {
            result += "\\t";
        } else if (code < 0x20 || code == 0x7f) {
            result += fmt::format("\\u{{{:x}}}", code);
        } else {
            result += c;
        }
    }
    return result + '"';
}

void DumpBlock::add_steps(const Transform& transform) {
    if (is_translation(transform)) {
        add("translate", transform.offset());
    } else if (transform.is_similarity()) {
        add("transform",
            fmt::format("similarity({}, {})", rows_of(transform), transform.similarity_scale()));
    } else {
        add("transform", fmt::format("matrix({})", rows_of(transform)));
    }
}

std::string DumpBlock::text(std::string_view head, std::size_t before, std::size_t indent) const {
    std::string text = std::string(head) + " {";
    if (items_.empty()) return text + " }";
    std::size_t width = before + head.size() + 4;
    for (const std::string& item : items_) width += item.size() + 2;
    if (width <= kWidth) {
        for (const std::string& item : items_) {
            text += &item == items_.data() ? " " : ", ";
            text += item;
        }
        return text + " }";
    }
    text += '\n';
    append_lines(text, indent + 2);
    text.append(indent, ' ');
    return text + "}";
}

void DumpBlock::append_lines(std::string& text, std::size_t indent) const {
    for (const std::string& item : items_) {
        text.append(indent, ' ');
        append_value(text, item, indent, indent);
        text += '\n';
    }
}

}  // namespace lray::parser
