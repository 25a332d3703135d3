#include "image/hdr.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace lray::image {

namespace {

constexpr std::uint32_t kLeastPackedWidth = 8;  // what is narrower is never packed in the new way
constexpr std::uint32_t kMostPackedWidth = 0x7fff;
constexpr std::size_t kMostLineSize = 4096;
constexpr double kMostCorrection = 1e30;

using Pixel = std::array<std::uint8_t, 4>;  // red, green, blue, exponent

constexpr std::string_view kEndsEarly = "the Radiance file ends early";

/// What of the header matters.
struct Header {
    DVec3 correction{1.0};  // what each channel was multiplied by
    std::uint32_t line_count = 0;
    std::uint32_t line_size = 0;
    bool lines_are_columns = false;
    bool is_right_to_left = false;
    bool is_bottom_up = false;

    std::uint32_t width() const { return lines_are_columns ? line_count : line_size; }
    std::uint32_t height() const { return lines_are_columns ? line_size : line_count; }

    /// Where a pixel of a line lies in the picture, by the index of Image::pixels.
    std::size_t index_of(std::uint32_t line, std::uint32_t i) const {
        std::uint32_t x = lines_are_columns ? line : i;
        std::uint32_t y = lines_are_columns ? i : line;
        if (is_right_to_left) x = width() - 1 - x;
        if (is_bottom_up) y = height() - 1 - y;
        return std::size_t{y} * width() + x;
    }
};

std::string_view skip_blanks(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(" \t\r"), text.size()));
}

template <class Number>
std::optional<Number> take_number(std::string_view& text) {
    text = skip_blanks(text);
    Number number{};
    const auto [rest, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
    return number;
}

/// Reads the lines of the header, from the first to that with the size.
class HeaderReader {
 public:
    HeaderReader(std::string_view text, std::string& error) : text_(text), error_(error) {}

    std::optional<Header> read() {
        if (!take_line()) return std::nullopt;  // "#?RADIANCE"
        for (;;) {
            if (!take_line()) return std::nullopt;
            if (skip_blanks(line_).empty()) break;
            if (!read_variable()) return std::nullopt;
        }
        if (!take_line()) return std::nullopt;
        if (!read_size()) {
            error_ = "the Radiance header needs a size like `-Y 480 +X 640` after an empty line";
            return std::nullopt;
        }
        return header_;
    }

    /// The pixels.
    std::string_view rest() const { return text_; }

 private:
    bool take_line() {
        const std::size_t end = text_.substr(0, kMostLineSize).find('\n');
        if (end == text_.npos) {
            error_ = text_.size() < kMostLineSize ? std::string(kEndsEarly)
                                                  : "a line of the Radiance header does not end";
            return false;
        }
        line_ = text_.substr(0, end);
        text_.remove_prefix(end + 1);
        return true;
    }

    bool read_variable() {
        const std::size_t equals = line_.find('=');
        if (line_.starts_with('#') || equals == line_.npos) return true;
        const std::string_view name = line_.substr(0, equals);
        std::string_view value = line_.substr(equals + 1);
        if (name == "EXPOSURE") {
            const auto exposure = take_number<double>(value);
            return correct_by(DVec3{exposure.value_or(0.0)});
        }
        if (name == "COLORCORR") {
            DVec3 factors{0.0};
            for (int i = 0; i < 3; ++i) factors[i] = take_number<double>(value).value_or(0.0);
            return correct_by(factors);
        }
        if (name == "FORMAT" && !skip_blanks(value).starts_with("32-bit_rle_rgbe")) {
            error_ = skip_blanks(value).starts_with("32-bit_rle_xyze")
                         ? "its colours are XYZ; save it as RGB"
                         : "its format is not 32-bit_rle_rgbe";
            return false;
        }
        return true;
    }

    /// There may be several: they multiply.
    bool correct_by(DVec3 factors) {
        header_.correction *= factors;
        for (int i = 0; i < 3; ++i) {
            const double factor = header_.correction[i];
            if (factor > 1.0 / kMostCorrection && factor < kMostCorrection) continue;
            error_ = "its exposure or colour correction is not a number above 0";
            return false;
        }
        return true;
    }

    /// The first axis is that from line to line.
    bool read_size() {
        std::string_view line = skip_blanks(line_);
        std::array<bool, 2> is_x{};
        std::array<std::uint32_t, 2> sizes{};
        for (std::size_t i = 0; i < 2; ++i) {
            line = skip_blanks(line);
            if (line.size() < 2) return false;
            const bool is_minus = line[0] == '-';
            if (!is_minus && line[0] != '+') return false;
            if (line[1] != 'X' && line[1] != 'Y') return false;
            is_x[i] = line[1] == 'X';
            (is_x[i] ? header_.is_right_to_left : header_.is_bottom_up) = is_x[i] == is_minus;
            line.remove_prefix(2);
            const auto size = take_number<std::uint32_t>(line);
            if (!size || *size == 0) return false;
            sizes[i] = *size;
        }
        if (is_x[0] == is_x[1]) return false;
        header_.lines_are_columns = is_x[0];
        header_.line_count = sizes[0];
        header_.line_size = sizes[1];
        return skip_blanks(line).empty();
    }

    std::string_view text_;
    std::string_view line_{};
    std::string& error_;
    Header header_{};
};

/// Unpacks lines of pixels one after the other.
class LineReader {
 public:
    LineReader(std::string_view bytes, std::uint32_t size) : bytes_(bytes), line_(size) {}

    /// Returns the next line; empty, and what is wrong is in error().
    const std::vector<Pixel>* next() {
        const bool is_read = begins_new_way() ? read_new_way() : read_old_way();
        return is_read ? &line_ : nullptr;
    }
    std::string_view error() const { return error_; }

 private:
    std::uint8_t byte(std::size_t i) const { return static_cast<std::uint8_t>(bytes_[i]); }

    bool fail(std::string_view error) {
        error_ = error;
        return false;
    }

    /// 2, 2 and the size of the line: no colour of the old way is written so.
    bool begins_new_way() const {
        return line_.size() >= kLeastPackedWidth && line_.size() <= kMostPackedWidth &&
               bytes_.size() >= 4 && byte(0) == 2 && byte(1) == 2 && byte(2) < 128;
    }

    /// All reds, then all greens and so on, each in runs and stretches.
    bool read_new_way() {
        if (std::size_t{byte(2)} * 256 + byte(3) != line_.size()) {
            return fail("a line of the Radiance file is not as long as the picture is wide");
        }
        bytes_.remove_prefix(4);
        for (std::size_t channel = 0; channel < 4; ++channel) {
            for (std::size_t i = 0; i < line_.size();) {
                if (bytes_.size() < 2) return fail(kEndsEarly);
                const bool is_run = byte(0) > 128;
                const std::size_t count = is_run ? byte(0) - 128u : byte(0);
                if (count == 0 || count > line_.size() - i) {
                    return fail("a line of the Radiance file is longer than it may be");
                }
                const std::size_t size = is_run ? 1 : count;
                if (bytes_.size() < 1 + size) return fail(kEndsEarly);
                for (std::size_t k = 0; k < count; ++k) {
                    line_[i + k][channel] = byte(1 + (is_run ? 0 : k));
                }
                i += count;
                bytes_.remove_prefix(1 + size);
            }
        }
        return true;
    }

    /// Pixels, of which 1, 1, 1, n repeats the one before n times, and n * 256 times if it follows
    /// another such.
    bool read_old_way() {
        unsigned shift = 0;
        for (std::size_t i = 0; i < line_.size();) {
            if (bytes_.size() < 4) return fail(kEndsEarly);
            const Pixel pixel{byte(0), byte(1), byte(2), byte(3)};
            bytes_.remove_prefix(4);
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                line_[i++] = pixel;
                shift = 0;
                continue;
            }
            const std::uint64_t count = std::uint64_t{pixel[3]} << shift;
            if (i == 0 || shift > 24 || count > line_.size() - i) {
                return fail("a line of the Radiance file is longer than it may be");
            }
            const auto at = line_.begin() + static_cast<std::ptrdiff_t>(i);
            std::fill_n(at, count, line_[i - 1]);
            i += count;
            shift += 8;
        }
        return true;
    }

    std::string_view bytes_;
    std::vector<Pixel> line_;
    std::string_view error_{};
};

/// The light of a pixel. Shape: `factors` undo the corrections.
Color light_of(const Pixel& pixel, DVec3 factors) {
    if (pixel[3] == 0) return Color{0.0f};
    const double unit = std::ldexp(1.0, int{pixel[3]} - (128 + 8));
    return Color{DVec3{pixel[0], pixel[1], pixel[2]} * unit * factors};
}

}  // namespace

bool is_hdr(std::span<const std::byte> file) {
    constexpr std::string_view kBeginnings[] = {"#?RADIANCE", "#?RGBE"};
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    return std::ranges::any_of(kBeginnings, [&](auto begin) { return text.starts_with(begin); });
}

std::optional<Image> read_hdr(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error) {
    if (!is_hdr(file)) {
        error = "this is not a Radiance picture";
        return std::nullopt;
    }
    HeaderReader reader({reinterpret_cast<const char*>(file.data()), file.size()}, error);
    const std::optional<Header> header = reader.read();
    if (!header) return std::nullopt;
    if (!limits.allow(header->width(), header->height(), error)) return std::nullopt;

    const DVec3 factors = DVec3{1.0} / header->correction;
    const std::uint64_t count = std::uint64_t{header->line_count} * header->line_size;
    // Lines are kept as they come: only as much memory is taken as the file has pixels for. Four
    // bytes hold one or a run of any length, a packed one has hardly less than one.
    std::vector<Color> pixels;
    pixels.reserve(std::min<std::uint64_t>(count, reader.rest().size()));
    LineReader lines(reader.rest(), header->line_size);
    for (std::uint32_t i = 0; i < header->line_count; ++i) {
        const std::vector<Pixel>* const line = lines.next();
        if (line == nullptr) {
            error = lines.error();
            return std::nullopt;
        }
        for (const Pixel& pixel : *line) pixels.push_back(light_of(pixel, factors));
    }
    Image image;
    image.width = header->width();
    image.height = header->height();
    if (!header->lines_are_columns && !header->is_right_to_left && !header->is_bottom_up) {
        image.pixels = std::move(pixels);
        return image;
    }
    image.pixels.resize(pixels.size());
    for (std::uint32_t line = 0; line < header->line_count; ++line) {
        for (std::uint32_t i = 0; i < header->line_size; ++i) {
            image.pixels[header->index_of(line, i)] =
                pixels[std::size_t{line} * header->line_size + i];
        }
    }
    return image;
}

}  // namespace lray::image
