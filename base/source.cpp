#include "base/source.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"

namespace lray {
namespace {

// A line table with an entry per block, not per line: 1 GiB of empty lines must not take 4 GiB.
constexpr std::size_t kBlockSize = 512;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// True if a line ends with this byte. The NUL padding of Text is the byte after the last.
bool ends_line(const char* byte) {
    return *byte == '\n' || (*byte == '\r' && byte[1] != '\n');
}

std::size_t count_line_ends(const Text& text, std::size_t begin, std::size_t end) {
    return static_cast<std::size_t>(std::count_if(text.data() + begin, text.data() + end,
                                                  [](const char& c) { return ends_line(&c); }));
}

bool continues_code_point(char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/// Counts code points from a place on; begins anew behind each line end.
std::uint32_t advance_column(const Text& text, std::size_t begin, std::size_t end,
                             std::uint32_t column) {
    for (std::size_t i = begin; i < end; ++i) {
        if (!continues_code_point(text.data()[i])) ++column;
        if (ends_line(text.data() + i)) column = 0;
    }
    return column;
}

}  // namespace

Text::Text(Uninitialized, std::size_t size)
    : bytes_(std::make_unique_for_overwrite<char[]>(size + kPadding)), size_(size) {
    std::memset(bytes_.get() + size, 0, kPadding);
}

Text::Text(std::string_view copied) : Text(Uninitialized{}, copied.size()) {
    std::copy(copied.begin(), copied.end(), bytes_.get());
}

Text Text::uninitialized(std::size_t size) {
    return Text(Uninitialized{}, size);
}

void Text::truncate(std::size_t size) {
    LRAY_ASSERT(size <= size_);
    size_ = size;
    std::memset(bytes_.get() + size, 0, kPadding);
}

SourceId Sources::add(std::string path, Text text, Span included_from) {
    LRAY_ASSERT(!is_full());
    LRAY_ASSERT(text.size() <= kMaxTextSize);
    sources_.push_back(Source{std::move(path), std::move(text), included_from});
    return static_cast<SourceId>(sources_.size() - 1);
}

const std::vector<std::uint32_t>& Sources::lines_before(const Source& source) const {
    std::vector<std::uint32_t>& table = source.lines_before;
    if (!table.empty()) return table;
    const std::size_t size = source.text.size();
    std::size_t count = 0;
    std::uint32_t column = 0;
    for (std::size_t begin = 0; begin <= size; begin += kBlockSize) {
        const std::size_t end = std::min(begin + kBlockSize, size);
        table.push_back(static_cast<std::uint32_t>(count));
        source.columns_before.push_back(column);
        count += count_line_ends(source.text, begin, end);
        column = advance_column(source.text, begin, end, column);
    }
    return table;
}

Position Sources::position(Span span) const {
    LRAY_ASSERT(span.source < sources_.size());
    const Source& source = sources_[span.source];
    const std::string_view text = source.text.view();
    const std::size_t offset = std::min<std::size_t>(span.offset, text.size());
    const std::size_t block = offset / kBlockSize;
    Position position;
    position.line += lines_before(source)[block] + static_cast<std::uint32_t>(count_line_ends(
                                                       source.text, block * kBlockSize, offset));
    position.column +=
        advance_column(source.text, block * kBlockSize, offset, source.columns_before[block]);
    const bool has_mark = position.line == 1 && text.starts_with(kByteOrderMark);
    if (has_mark && position.column > 1) --position.column;
    return position;
}

std::string_view Sources::line(SourceId id, std::uint32_t number) const {
    const Source& source = sources_[id];
    const std::string_view text = source.text.view();
    const std::vector<std::uint32_t>& table = lines_before(source);
    LRAY_ASSERT(number >= 1);
    // The line begins behind the line end number - 1, which stands in the last block with fewer
    // line ends than that before it.
    std::size_t begin = 0;
    if (number > 1) {
        const auto block = std::lower_bound(table.begin(), table.end(), number - 1) - 1;
        std::size_t left = number - 1 - *block;
        begin = static_cast<std::size_t>(block - table.begin()) * kBlockSize;
        for (; left > 0 && begin < text.size(); ++begin) {
            if (ends_line(text.data() + begin)) --left;
        }
        LRAY_ASSERT(left == 0);
    }
    // One search after the other: each is the library's fastest, and lines may have megabytes.
    const std::size_t line_feed = std::min(text.find('\n', begin), text.size());
    const std::size_t end = std::min(text.substr(0, line_feed).find('\r', begin), line_feed);
    if (begin == 0 && text.starts_with(kByteOrderMark)) begin = kByteOrderMark.size();
    return text.substr(begin, end - begin);
}

std::uint32_t Sources::line_count(SourceId id) const {
    const Source& source = sources_[id];
    const std::vector<std::uint32_t>& table = lines_before(source);
    const std::size_t last_block = (table.size() - 1) * kBlockSize;
    return 1 + table.back() +
           static_cast<std::uint32_t>(count_line_ends(source.text, last_block, source.text.size()));
}

std::string_view Sources::text(Span span) const {
    if (span.is_nowhere()) return {};
    const std::string_view text = sources_[span.source].text.view();
    if (span.offset >= text.size()) return {};
    return text.substr(span.offset, span.length);
}

void Sources::release_text(SourceId id) {
    sources_[id].text = Text{};
    sources_[id].lines_before.clear();
    sources_[id].columns_before.clear();
}

}  // namespace lray
