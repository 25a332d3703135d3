#include "scene/formats/ply_ascii.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/parse_number.h"

namespace lray::scene::ply {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/// At the end of the text, too, where a NUL stands.
bool is_line_end(char c) {
    return c == '\n' || c == '\r' || c == '\0';
}

bool is_word_end(char c) {
    return is_blank(c) || is_line_end(c);
}

/// Returns the value of a word that is no decimal number: `nan`, `inf` and what begins like them.
std::optional<double> parse_not_finite(std::string_view word) {
    std::string lower(word.substr(0, 3));
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    if (lower == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (lower == "inf") return std::numeric_limits<double>::infinity();
    return {};
}

}  // namespace

const char* AsciiRows::skip(std::size_t element_index, const char* at) {
    element_ = element_index;
    at_ = at;
    if (element().properties.empty()) return at;
    for (row_ = 0; row_ < element().count; ++row_) {
        if (!begin_row()) return nullptr;
        for (const Property& property : element().properties) {
            const bool is_read = property.is_list ? skip_list(property) : read_number().has_value();
            if (!is_read) return nullptr;
        }
        end_row();
    }
    return at_;
}

const char* AsciiRows::read_vertices(const char* at) {
    element_ = layout_.vertex_element;
    at_ = at;
    builder_.reserve_vertices(element().count);
    std::vector<std::size_t> slots(element().properties.size(), Layout::kNone);
    for (std::size_t slot = 0; slot < kSlotCount; ++slot) {
        if (layout_.properties[slot] != Layout::kNone) slots[layout_.properties[slot]] = slot;
    }
    VertexBlock block;
    for (row_ = 0; row_ < element().count; ++row_) {
        if (!begin_row()) return nullptr;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const Property& property = element().properties[i];
            if (property.is_list) {
                if (!skip_list(property)) return nullptr;
                continue;
            }
            const std::optional<double> number = read_number();
            if (!number) return nullptr;
            if (slots[i] == Layout::kNone) continue;
            block.values[slots[i]][block.count] = static_cast<float>(*number);
        }
        lines_[block.count++] = {row_begin_, static_cast<std::size_t>(at_ - row_begin_)};
        end_row();
        if (block.count == VertexBlock::kCapacity && !add_vertices(block)) return nullptr;
    }
    return add_vertices(block) ? at_ : nullptr;
}

bool AsciiRows::add_vertices(VertexBlock& block) {
    const std::size_t first = builder_.vertex_count();
    const std::size_t added = builder_.add_vertices(block);
    if (added < block.count) {
        return wrong(lines_[added],
                     fmt::format("vertex {} has a number that is not finite, or beyond 3.4e38",
                                 first + added));
    }
    block.count = 0;
    return true;
}

const char* AsciiRows::read_indices(const IndexLists& lists, const char* at) {
    element_ = lists.element;
    at_ = at;
    if (!lists.are_strips) builder_.reserve_triangles(element().count);
    for (row_ = 0; row_ < element().count; ++row_) {
        if (!begin_row()) return nullptr;
        for (std::size_t i = 0; i < element().properties.size(); ++i) {
            const Property& property = element().properties[i];
            const bool is_read = i == lists.property ? read_index_list(lists.are_strips, property)
                                 : property.is_list  ? skip_list(property)
                                                     : read_number().has_value();
            if (!is_read) return nullptr;
        }
        end_row();
    }
    return at_;
}

bool AsciiRows::read_index_list(bool are_strips, const Property& property) {
    const char* const begin = at_;
    const std::optional<std::uint64_t> count = read_count(property);
    if (!count) return false;
    if (!are_strips && (*count < 3 || *count > kMaxCorners)) {
        const std::string_view place = {begin, static_cast<std::size_t>(at_ - begin)};
        const std::string_view number = place.substr(place.find_first_not_of(" \t"));
        if (*count < 3) {
            return wrong(number,
                         fmt::format("a face needs at least 3 corners, this has {}", *count));
        }
        return wrong(number,
                     fmt::format("a face can have {} corners, this has {}", kMaxCorners, *count),
                     Code::E0705);
    }
    corners_.clear();
    builder_.end_strip();
    const auto vertex_count = static_cast<std::int64_t>(builder_.vertex_count());
    for (std::uint64_t i = 0; i < *count; ++i) {
        const std::optional<std::int64_t> index = read_whole();
        if (!index) return false;
        if (are_strips && *index == -1) {
            builder_.end_strip();
        } else if (*index < 0 || *index >= vertex_count) {
            const char* first = at_;
            while (!is_word_end(first[-1])) --first;
            return wrong({first, static_cast<std::size_t>(at_ - first)},
                         fmt::format("{} {} names vertex {} of {}", are_strips ? "strip" : "face",
                                     row_, *index, vertex_count),
                         Code::E0702);
        } else if (are_strips) {
            builder_.continue_strip(static_cast<std::uint32_t>(*index));
        } else {
            corners_.push_back(static_cast<std::uint32_t>(*index));
        }
    }
    if (!are_strips) builder_.add_face(corners_);
    return true;
}

bool AsciiRows::skip_list(const Property& property) {
    const std::optional<std::uint64_t> count = read_count(property);
    if (!count) return false;
    for (std::uint64_t i = 0; i < *count; ++i) {
        if (!read_number()) return false;
    }
    return true;
}

bool AsciiRows::begin_row() {
    while (is_blank(*at_) || *at_ == '\n' || *at_ == '\r') ++at_;
    row_begin_ = at_;
    value_count_ = 0;
    if (at_ < end_) return true;
    return wrong({end_, 0}, fmt::format("the file ends before {} {} of {}", quoted(element().name),
                                        row_, element().count));
}

void AsciiRows::end_row() {
    while (!is_line_end(*at_)) ++at_;
}

/// Goes to the next value of the row.
bool AsciiRows::begin_value() {
    while (is_blank(*at_)) ++at_;
    if (!is_line_end(*at_)) return true;
    if (*at_ == '\0' && at_ < end_) {
        mistakes_.in_bytes(Code::E0003, fmt::format("this file says that it is text, but byte {} "
                                                    "of it is NUL",
                                                    mistakes_.byte_at(at_)));
        return false;
    }
    std::string_view row = {row_begin_, static_cast<std::size_t>(at_ - row_begin_)};
    row = row.substr(0, row.find_last_not_of(" \t") + 1);
    return wrong(
        row, fmt::format("{} {} goes on, but its line has only {} number{}", quoted(element().name),
                         row_, value_count_, value_count_ == 1 ? "" : "s"));
}

std::optional<double> AsciiRows::read_number() {
    if (!begin_value()) return {};
    const bool is_negative = *at_ == '-';
    const ParsedNumber number = parse_decimal(is_negative || *at_ == '+' ? at_ + 1 : at_);
    double value = number.value;
    if (number.is_found() && is_word_end(*number.end)) {
        at_ = number.end;
    } else {
        const std::string_view found = word();
        const std::optional<double> special =
            parse_not_finite(found.substr(*at_ == '-' || *at_ == '+' ? 1 : 0));
        if (!special) {
            (void)wrong(found, fmt::format("expected a number, found {}", quoted(found)));
            return {};
        }
        value = *special;
        at_ += found.size();
    }
    ++value_count_;
    return is_negative ? -value : value;
}

std::optional<std::int64_t> AsciiRows::read_whole() {
    if (!begin_value()) return {};
    const char* digits = at_;
    if (*digits == '-' || *digits == '+') ++digits;
    const DigitRun run = read_digit_run(digits);
    if (run.count > 0 && is_word_end(digits[run.count])) {
        const auto value = static_cast<std::int64_t>(run.value);
        const bool is_negative = *at_ == '-';
        at_ = digits + run.count;
        ++value_count_;
        return is_negative ? -value : value;
    }
    const std::string_view found = word();
    const std::optional<double> number = read_number();
    if (!number) return {};
    constexpr double kMost = 1e15;
    if (!(std::abs(*number) < kMost) || std::floor(*number) != *number) {
        (void)wrong(found, fmt::format("expected a whole number, found {}", quoted(found)));
        return {};
    }
    return static_cast<std::int64_t>(*number);
}

std::optional<std::uint64_t> AsciiRows::read_count(const Property& property) {
    const std::optional<std::int64_t> count = read_whole();
    if (!count) return {};
    if (*count < 0) {
        const char* first = at_;
        while (!is_word_end(first[-1])) --first;
        (void)wrong({first, static_cast<std::size_t>(at_ - first)},
                    fmt::format("a list {} of {} values", quoted(property.name), *count));
        return {};
    }
    return static_cast<std::uint64_t>(*count);
}

std::string_view AsciiRows::word() const {
    const char* end = at_;
    while (!is_word_end(*end)) ++end;
    return {at_, static_cast<std::size_t>(end - at_)};
}

bool AsciiRows::wrong(std::string_view place, std::string message, Code code) {
    mistakes_.in_text(code, place, std::move(message));
    return false;
}

}  // namespace lray::scene::ply
