#include "base/excerpt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/terminal_text.h"

namespace lray {
namespace {

constexpr std::size_t kTabStop = 4;
constexpr std::size_t kMaxColumns = 100;            // of source text
constexpr std::size_t kMaxBytes = 8 * kMaxColumns;  // of them: combining marks take no column
constexpr std::string_view kCut = "...";

/// The part of a mark that lies on one line; bytes count from the begin of the line.
struct LineMark {
    std::uint32_t line = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string_view text{};
    bool is_primary = false;
};

/// A line as it is shown: what to print, and at which column each byte of it stands.
class ShownLine {
 public:
    /// Shows the whole line if it is short, else a stretch of it around the byte `focus`.
    ShownLine(std::string_view line, std::size_t focus) {
        if (line.size() <= kMaxBytes) {
            lay_out(line, 0, kNoLimit);
            if (column_ <= kMaxColumns) return;
        }
        *this = ShownLine();
        std::size_t begin = std::min(focus, line.size());
        constexpr int kColumnsBefore = 30;
        for (int i = 0; i < kColumnsBefore && begin > 0; ++i) begin = previous(line, begin);
        if (begin > 0) {
            text_ = kCut;
            column_ = kCut.size();
        }
        lay_out(line, begin, kMaxColumns - kCut.size());
    }

    const std::string& text() const { return text_; }

    /// Returns the column of a byte; of one that is cut off, that of the dots in its place.
    std::size_t column(std::size_t byte) const {
        if (glyphs_.empty() || byte >= end_) return end_column_;
        const auto after = std::upper_bound(
            glyphs_.begin(), glyphs_.end(), byte,
            [](std::size_t value, const auto& glyph) { return value < glyph.first; });
        return after == glyphs_.begin() ? 0 : (after - 1)->second;
    }

 private:
    static constexpr std::size_t kNoLimit = ~std::size_t{0};

    ShownLine() = default;

    static std::size_t previous(std::string_view line, std::size_t byte) {
        constexpr std::size_t kLongest = 4;  // bytes of a code point
        const std::size_t least = byte - std::min(byte, kLongest);
        for (std::size_t begin = byte - 1; begin > least; --begin) {
            if ((static_cast<unsigned char>(line[begin]) & 0xc0u) != 0x80u) return begin;
        }
        return byte - 1;
    }

    void lay_out(std::string_view line, std::size_t begin, std::size_t limit) {
        std::size_t byte = begin;
        while (byte < line.size()) {
            const bool is_tab = line[byte] == '\t';
            const Glyph glyph = first_glyph(line.substr(byte));
            const std::size_t width = is_tab ? kTabStop - column_ % kTabStop : glyph.width;
            if (column_ + width > limit || byte - begin >= kMaxBytes) break;
            glyphs_.emplace_back(byte, column_);
            if (is_tab) {
                text_.append(width, ' ');
            } else {
                text_ += glyph.text();
            }
            column_ += width;
            byte += glyph.size;
        }
        end_ = byte;
        end_column_ = column_;
        if (byte < line.size()) text_ += kCut;
    }

    std::string text_{};
    std::vector<std::pair<std::size_t, std::size_t>> glyphs_{};  // first byte, column
    std::size_t column_ = 0;
    std::size_t end_ = 0;         // the first byte that is not shown
    std::size_t end_column_ = 0;  // its column
};

/// A row of single characters, each in a style of its own.
class Row {
 public:
    void put(std::size_t column, char c, std::string_view style) {
        if (cells_.size() <= column) cells_.resize(column + 1);
        cells_[column] = {c, style};
    }
    std::size_t size() const { return cells_.size(); }

    std::string text(std::string_view reset) const {
        std::string result;
        std::string_view current;
        for (const Cell& cell : cells_) {
            if (cell.style != current && !current.empty()) result += reset;
            if (cell.style != current) result += cell.style;
            current = cell.style;
            result += cell.c;
        }
        if (!current.empty()) result += reset;
        return result;
    }

 private:
    struct Cell {
        char c = ' ';
        std::string_view style{};
    };
    std::vector<Cell> cells_;
};

std::string gutter(std::string_view number, std::size_t width, const Palette& palette) {
    return fmt::format("{}{:>{}} |{}", palette.gutter, number, width, palette.reset);
}

std::string in_style(std::string_view text, std::string_view style, const Palette& palette) {
    return fmt::format("{}{}{}", style, escape_for_terminal(text, kMaxMessageSize),
                       style.empty() ? std::string_view{} : palette.reset);
}

/// Returns the lines below a line of source: the marks, the text of the mark that ends last beside
/// them, and a line for the text of each other mark, the rightmost first.
/// Shape: at least one mark.
std::vector<std::string> format_marks(const ShownLine& shown, std::span<const LineMark> marks,
                                      const Palette& palette) {
    struct Placed {
        std::size_t begin = 0;
        std::size_t end = 0;
        const LineMark* mark = nullptr;
    };
    const auto style = [&](const LineMark& mark) {
        return mark.is_primary ? palette.primary : palette.secondary;
    };
    std::vector<Placed> placed;
    for (const LineMark& mark : marks) {
        const std::size_t begin = shown.column(mark.begin);
        placed.push_back({begin, std::max(begin + 1, shown.column(mark.end)), &mark});
    }
    Row row;
    for (const bool is_primary : {false, true}) {  // carets go over dashes
        for (const Placed& p : placed) {
            if (p.mark->is_primary != is_primary) continue;
            const char c = is_primary ? '^' : '-';
            for (std::size_t i = p.begin; i < p.end; ++i) row.put(i, c, style(*p.mark));
        }
    }
    std::stable_sort(placed.begin(), placed.end(),
                     [](const Placed& a, const Placed& b) { return a.begin < b.begin; });
    std::vector<std::string> lines{row.text(palette.reset)};
    // Beside the row stands the text of the mark that ends it, so that it is taken for no other's.
    const auto last =
        std::max_element(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
            return std::pair(a.end, a.begin) < std::pair(b.end, b.begin);
        });
    if (!last->mark->text.empty()) {
        lines[0] += " " + in_style(last->mark->text, style(*last->mark), palette);
        placed.erase(last);
    }
    std::erase_if(placed, [](const Placed& p) { return p.mark->text.empty(); });
    while (!placed.empty()) {
        const Placed current = placed.back();
        placed.pop_back();
        Row connectors;
        for (const Placed& p : placed) {
            if (p.begin < current.begin) connectors.put(p.begin, '|', style(*p.mark));
        }
        const std::string indent(current.begin - std::min(current.begin, connectors.size()), ' ');
        lines.push_back(connectors.text(palette.reset) + indent +
                        in_style(current.mark->text, style(*current.mark), palette));
    }
    return lines;
}

std::uint32_t last_line(const Sources& sources, Span span) {
    // A line end belongs to its line: the last byte counts, not the one after it.
    Span last = span;
    last.offset += span.length > 0 ? span.length - 1u : 0u;
    return sources.position(last).line;
}

std::vector<LineMark> line_marks(const Sources& sources, std::span<const Mark> marks) {
    std::vector<LineMark> result;
    for (const Mark& mark : marks) {
        const SourceId id = mark.span.source;
        const char* text = sources[id].text.data();
        const std::uint32_t first = sources.position(mark.span).line;
        const std::uint32_t last = last_line(sources, mark.span);
        const std::string_view first_text = sources.line(id, first);
        const std::string_view last_text = sources.line(id, last);
        // Bytes of the file -> bytes of the line, which may end before its line end.
        const auto byte_in = [&](std::string_view line, std::size_t offset) {
            const auto begin = static_cast<std::size_t>(line.data() - text);
            return std::min(offset - std::min(offset, begin), line.size());
        };
        const std::size_t begin = byte_in(first_text, mark.span.offset);
        const std::size_t end =
            byte_in(last_text, std::size_t{mark.span.offset} + mark.span.length);
        if (first == last) {
            result.push_back({first, begin, end, mark.text, mark.is_primary});
            continue;
        }
        const std::size_t indent = std::min(last_text.find_first_not_of(" \t"), last_text.size());
        result.push_back({first, begin, first_text.size(), {}, mark.is_primary});
        result.push_back({last, std::min(indent, end), end, mark.text, mark.is_primary});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const LineMark& a, const LineMark& b) { return a.line < b.line; });
    return result;
}

}  // namespace

std::size_t line_number_width(const Sources& sources, std::span<const Mark> marks) {
    std::size_t width = 1;
    for (const Mark& mark : marks) {
        width = std::max(width, fmt::formatted_size("{}", last_line(sources, mark.span)));
    }
    return width;
}

std::string format_excerpt(const Sources& sources, std::span<const Mark> marks,
                           std::size_t number_width, const Palette& palette) {
    const std::string blank = gutter("", number_width, palette);
    std::string result = blank + "\n";
    const std::vector<LineMark> all = line_marks(sources, marks);
    for (auto first = all.begin(); first != all.end();) {
        const auto end = std::find_if(
            first, all.end(), [&](const LineMark& mark) { return mark.line != first->line; });
        if (first != all.begin() && first->line > (first - 1)->line + 1) {
            result += fmt::format("{}{}{}\n", palette.gutter, kCut, palette.reset);
        }
        const auto focus = std::find_if(first, end, [](const LineMark& m) { return m.is_primary; });
        const ShownLine shown(sources.line(marks[0].span.source, first->line),
                              (focus == end ? first : focus)->begin);
        result += gutter(std::to_string(first->line), number_width, palette);
        if (!shown.text().empty()) result += " " + shown.text();
        result += '\n';
        for (const std::string& line : format_marks(shown, {first, end}, palette)) {
            result += fmt::format("{} {}\n", blank, line);
        }
        first = end;
    }
    return result;
}

}  // namespace lray
