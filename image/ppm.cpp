#include "image/ppm.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "image/srgb.h"

namespace lray::image {

namespace {

constexpr std::size_t kBatchSize = std::size_t{1} << 16;  // bytes handed to the file at a time

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Walks over the header: the magic number and three numbers, divided by white space and comments.
class HeaderReader {
 public:
    explicit HeaderReader(std::string_view text) : text_(text) {}

    bool take_magic() {
        if (!text_.starts_with("P6")) return false;
        at_ = 2;
        return true;
    }

    std::optional<std::uint32_t> take_number() {
        const std::size_t before = at_;
        skip_space();
        if (at_ == before) return std::nullopt;
        std::uint32_t number = 0;
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

 private:
    void skip_space() {
        while (at_ < text_.size()) {
            if (text_[at_] == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
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

}  // namespace

bool write_ppm(OutputFile& out, const Image& image, Gamma gamma) {
    LRAY_ASSERT(image.width > 0 && image.height > 0);
    if (!out.write(fmt::format("P6\n{} {}\n255\n", image.width, image.height))) return false;

    const std::size_t batch = std::max<std::size_t>(1, kBatchSize / 3);
    std::vector<std::uint8_t> bytes(3 * std::min(batch, image.pixels.size()));
    for (std::size_t first = 0; first < image.pixels.size(); first += batch) {
        const std::size_t count = std::min(batch, image.pixels.size() - first);
        const std::span row = std::span(bytes).first(3 * count);
        encode_row(std::span(image.pixels).subspan(first, count), gamma, row);
        if (!out.write(std::as_bytes(row))) return false;
    }
    return true;
}

std::optional<CodedImage> read_ppm(std::span<const std::byte> file, const ReadLimits& limits,
                                   std::string& error) {
    HeaderReader header({reinterpret_cast<const char*>(file.data()), file.size()});
    if (!header.take_magic()) {
        error = "this is not a binary PPM (P6) file";
        return std::nullopt;
    }
    const auto width = header.take_number();
    const auto height = header.take_number();
    const auto maximum = header.take_number();
    const auto pixels = header.take_pixels();
    if (!width || !height || !maximum || !pixels || *width == 0 || *height == 0) {
        error = "the PPM header needs a width, a height and a maximum";
        return std::nullopt;
    }
    if (*maximum != 255) {
        error = fmt::format("the PPM maximum is {}; only 255 is read", *maximum);
        return std::nullopt;
    }
    if (!limits.allow(*width, *height, error)) return std::nullopt;
    const std::uint64_t needed = std::uint64_t{3} * *width * *height;
    if (pixels->size() < needed) {
        error = fmt::format("the PPM file ends early: {} of {} bytes of pixels", pixels->size(),
                            needed);
        return std::nullopt;
    }
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels->data());
    return CodedImage{*width, *height, {bytes, bytes + needed}};
}

}  // namespace lray::image
