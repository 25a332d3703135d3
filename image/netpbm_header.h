// Walks over the header of a PPM, PGM or PFM file: words divided by white space and comments.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace lray::image {

class NetpbmHeader {
 public:
    explicit NetpbmHeader(std::span<const std::byte> file)
        : text_(reinterpret_cast<const char*>(file.data()), file.size()) {}

    static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    /// Steps over the two characters that the file begins with.
    void skip_magic() { at_ = text_.size() < 2 ? text_.size() : 2; }

    /// Returns the number that comes next, after white space; empty if there is none.
    template <class Number>
    std::optional<Number> take_number() {
        const std::size_t before = at_;
        skip_space();
        if (at_ == before) return std::nullopt;
        Number number{};
        const char* const end = text_.data() + text_.size();
        const auto [rest, code] = std::from_chars(text_.data() + at_, end, number);
        if (code != std::errc{}) return std::nullopt;
        at_ = static_cast<std::size_t>(rest - text_.data());
        return number;
    }

    /// One white space divides the header from the pixels; returns what follows it.
    std::optional<std::string_view> take_pixels() {
        if (at_ >= text_.size() || !is_space(text_[at_])) return std::nullopt;
        return text_.substr(at_ + 1);
    }

    std::size_t rest_size() const { return text_.size() - at_; }

 private:
    void skip_space() {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') {
                const std::size_t end = text_.find('\n', at_);
                at_ = end == text_.npos ? text_.size() : end;
            } else if (is_space(text_[at_])) {
                ++at_;
            } else {
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace lray::image
