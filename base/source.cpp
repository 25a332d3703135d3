#include "base/source.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"

namespace lray {

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
    sources_.push_back(Source{std::move(path), std::move(text), included_from});
    return static_cast<SourceId>(sources_.size() - 1);
}

const std::vector<std::uint32_t>& Sources::line_starts(const Source& source) const {
    std::vector<std::uint32_t>& starts = source.line_starts;
    if (!starts.empty()) return starts;
    const std::string_view text = source.text.view();
    starts.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool ends_line =
            text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
        if (ends_line) starts.push_back(static_cast<std::uint32_t>(i + 1));
    }
    return starts;
}

Position Sources::position(Span span) const {
    const Source& source = sources_[span.source];
    const std::vector<std::uint32_t>& starts = line_starts(source);
    const auto after = std::upper_bound(starts.begin(), starts.end(), span.offset);
    const std::uint32_t start = *(after - 1);
    Position position;
    position.line = static_cast<std::uint32_t>(after - starts.begin());
    const std::string_view text = source.text.view();
    std::size_t begin = start;
    if (start == 0 && text.starts_with("\xEF\xBB\xBF")) begin = 3;
    for (std::size_t i = begin; i < std::min<std::size_t>(span.offset, text.size()); ++i) {
        const bool continues_code_point = (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u;
        if (!continues_code_point) ++position.column;
    }
    return position;
}

std::string_view Sources::line(SourceId id, std::uint32_t number) const {
    const Source& source = sources_[id];
    const std::vector<std::uint32_t>& starts = line_starts(source);
    LRAY_ASSERT(number >= 1 && number <= starts.size());
    const std::string_view text = source.text.view();
    const std::size_t begin = starts[number - 1];
    std::size_t end = number < starts.size() ? starts[number] : text.size();
    while (end > begin && (text[end - 1] == '\n' || text[end - 1] == '\r')) --end;
    return text.substr(begin, end - begin);
}

std::uint32_t Sources::line_count(SourceId id) const {
    return static_cast<std::uint32_t>(line_starts(sources_[id]).size());
}

std::string_view Sources::text(Span span) const {
    if (span.is_nowhere()) return {};
    const std::string_view text = sources_[span.source].text.view();
    if (span.offset >= text.size()) return {};
    return text.substr(span.offset, span.length);
}

void Sources::release_text(SourceId id) {
    sources_[id].text = Text{};
    sources_[id].line_starts.clear();
}

}  // namespace lray
