// Source text and places in it: what spans mean, and where lines begin. Reading files is
// base/file_access.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lray {

/// The bytes of a file, followed by kPadding NUL bytes that are not part of it, so that a scanner
/// needs no end check per byte.
class Text {
 public:
    static constexpr std::size_t kPadding = 64;

    Text() : Text(std::string_view{}) {}
    explicit Text(std::string_view copied);

    /// Makes a text of `size` bytes that are not yet written.
    static Text uninitialized(std::size_t size);

    Text(Text&& other) noexcept
        : bytes_(std::move(other.bytes_)), size_(std::exchange(other.size_, 0)) {}
    Text& operator=(Text&& other) noexcept {
        bytes_ = std::move(other.bytes_);
        size_ = std::exchange(other.size_, 0);
        return *this;
    }

    char* data() { return bytes_.get(); }
    const char* data() const { return bytes_.get(); }
    std::size_t size() const { return size_; }
    std::string_view view() const { return {bytes_.get(), size_}; }

    /// Makes the text shorter: for a file that turned out to be.
    void truncate(std::size_t size);

 private:
    struct Uninitialized {};
    Text(Uninitialized, std::size_t size);

    std::unique_ptr<char[]> bytes_;
    std::size_t size_ = 0;
};

/// Index of a file in Sources.
using SourceId = std::uint16_t;
inline constexpr SourceId kNoSource = 0xffff;

/// A stretch of source text in 8 bytes. A default-made one is nowhere (e.g. the command line).
struct Span {
    std::uint32_t offset = 0;
    SourceId source = kNoSource;
    std::uint16_t length = 0;  // saturates at 65535; the begin is always exact

    static constexpr std::size_t kMaxLength = 0xffff;

    static constexpr Span make(SourceId source, std::size_t begin, std::size_t end) {
        const std::size_t length = end - begin;
        return {static_cast<std::uint32_t>(begin), source,
                static_cast<std::uint16_t>(length < kMaxLength ? length : kMaxLength)};
    }

    constexpr bool is_nowhere() const { return source == kNoSource; }
    constexpr std::uint32_t end() const { return offset + length; }
    friend constexpr bool operator==(Span, Span) = default;
};

/// Returns the span from the begin of `first` to the end of `last` (same source).
constexpr Span join(Span first, Span last) {
    return Span::make(first.source, first.offset, last.end());
}

/// 1-based line; 1-based column in code points.
struct Position {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// A file that spans refer to.
struct Source {
    std::string path;  // as shown to the user
    Text text;
    Span included_from{};  // the include that brought it; nowhere for the main file

    // Of each block, made on first use: the line ends before it, and the code points between the
    // last of them and the block.
    mutable std::vector<std::uint32_t> lines_before{};
    mutable std::vector<std::uint32_t> columns_before{};
};

/// All source text of a run. References stay valid as files are added.
class Sources {
 public:
    static constexpr std::size_t kMaxCount = kNoSource;
    static constexpr std::size_t kMaxTextSize = 0xffffffff;  // what an offset can address

    /// Errors: asserts that fewer than kMaxCount are held (callers check is_full() first) and that
    /// the text is at most kMaxTextSize long.
    SourceId add(std::string path, Text text, Span included_from = {});

    bool is_full() const { return sources_.size() >= kMaxCount; }
    std::size_t count() const { return sources_.size(); }
    const Source& operator[](SourceId id) const { return sources_[id]; }

    /// Line and column of the begin of the span, which is not nowhere. A byte order mark is no
    /// column. Takes no longer in a line of a gigabyte.
    Position position(Span span) const;

    /// The text of a line (1-based) without its line end and without a byte order mark. `\n`,
    /// `\r\n` and `\r` end a line.
    std::string_view line(SourceId id, std::uint32_t number) const;

    std::uint32_t line_count(SourceId id) const;

    /// The text a span covers.
    std::string_view text(Span span) const;

    /// Forgets the text of a source but keeps its name: for meshes read without a complaint.
    void release_text(SourceId id);

 private:
    const std::vector<std::uint32_t>& lines_before(const Source& source) const;

    std::deque<Source> sources_;
};

}  // namespace lray
