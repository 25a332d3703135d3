// PNG through libpng, row by row. libpng reports errors with longjmp: each function that calls it
// sets its own jump target and holds nothing with a destructor while libpng runs.
#include "image/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <string_view>
#include <vector>

#include "image/srgb.h"

namespace lray::image {

namespace {

constexpr std::size_t kMaxKeywordSize = 79;  // PNG 1.2, 11.3.4.3
constexpr std::size_t kSignatureSize = 8;
constexpr std::uint32_t kMaxWriteSide = PNG_UINT_31_MAX;
// What a chunk other than the pixels may take when reading.
constexpr png_alloc_size_t kMaxChunkSize = 8'000'000;
// Deflate packs 258 bytes into two bits at best.
constexpr std::uint64_t kMostInflation = 1032;

constexpr png_byte kTransparency[] = {'t', 'R', 'N', 'S', 0};

/// The first error libpng reports; of fixed size, so that no destructor is jumped over.
struct Failure {
    std::array<char, 128> message{};
};

extern "C" {

[[noreturn]] static void on_error(png_structp png, png_const_charp message) {
    auto& failure = *static_cast<Failure*>(png_get_error_ptr(png));
    std::strncpy(failure.message.data(), message, failure.message.size() - 1);
    png_longjmp(png, 1);
}

/// Of a chunk that is read, a warning means damage; when writing there is nothing to warn of.
static void on_read_warning(png_structp png, png_const_charp message) {
    on_error(png, message);
}

static void on_write_warning(png_structp, png_const_charp) {}

static void on_write(png_structp png, png_bytep bytes, std::size_t size) {
    auto& out = *static_cast<OutputFile*>(png_get_io_ptr(png));
    if (!out.write(std::as_bytes(std::span(bytes, size)))) png_error(png, "write failed");
}

static void on_flush(png_structp) {}

static void on_read(png_structp png, png_bytep bytes, std::size_t size) {
    auto& rest = *static_cast<std::span<const std::byte>*>(png_get_io_ptr(png));
    if (rest.size() < size) png_error(png, "the file ends early");
    std::memcpy(bytes, rest.data(), size);
    rest = rest.subspan(size);
}

}  // extern "C"

struct Writer {
    Failure failure{};
    png_structp png = nullptr;
    png_infop info = nullptr;

    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }

    bool open(OutputFile& out) {
        png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_write_warning);
        if (png == nullptr) return false;
        info = png_create_info_struct(png);
        if (info == nullptr) return false;
        png_set_write_fn(png, &out, on_write, on_flush);
        return true;
    }

    bool begin(std::uint32_t width, std::uint32_t height, Gamma gamma, int bits,
               std::span<png_text> texts) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_set_user_limits(png, kMaxWriteSide, kMaxWriteSide);
        png_set_IHDR(png, info, width, height, bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        if (gamma == Gamma::srgb) {
            png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        } else {
            png_set_gAMA_fixed(png, info, PNG_FP_1);
        }
        if (!texts.empty()) png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
        png_write_info(png, info);
        return true;
    }

    bool write_row(const std::uint8_t* bytes) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_write_row(png, bytes);
        return true;
    }

    bool end() {
        if (setjmp(png_jmpbuf(png))) return false;
        png_write_end(png, info);
        return true;
    }
};

struct Reader {
    Failure failure{};
    std::span<const std::byte> rest{};
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit Reader(std::span<const std::byte> file) : rest(file) {}
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

    bool open() {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_read_warning);
        if (png == nullptr) return false;
        info = png_create_info_struct(png);
        if (info == nullptr) return false;
        png_set_read_fn(png, &rest, on_read);
        return true;
    }

    bool read_header() {
        if (setjmp(png_jmpbuf(png))) return false;
        png_set_chunk_malloc_max(png, kMaxChunkSize);
        png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours are in pixels
        // Nothing but the pixels is of use: all that may be left out is, and what libpng does not
        // know; transparency is not among the former.
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kTransparency, 1);
        png_read_info(png, info);
        png_set_expand(png);
        png_set_gray_to_rgb(png);
        png_set_strip_alpha(png);
        return true;
    }

    std::uint32_t width() const { return png_get_image_width(png, info); }
    std::uint32_t height() const { return png_get_image_height(png, info); }

    bool is_deep() const { return png_get_bit_depth(png, info) == 16; }

    /// The least bytes of file that so many pixels can be packed in.
    std::uint64_t least_size() const {
        const std::uint64_t bits_of_row =
            std::uint64_t{width()} * png_get_bit_depth(png, info) * png_get_channels(png, info);
        return (bits_of_row / 8) * height() / kMostInflation;
    }

    /// Interlaced files come in several passes over all rows.
    /// Shape: 3 width height codes, of 2 bytes in the order of this machine if it is deep.
    bool read_rows(std::uint8_t* bytes) {
        if (setjmp(png_jmpbuf(png))) return false;
        if (is_deep()) png_set_swap(png);
        const int pass_count = png_set_interlace_handling(png);
        png_read_update_info(png, info);
        const std::size_t row_size = std::size_t{is_deep() ? 6u : 3u} * width();
        if (png_get_rowbytes(png, info) != row_size) png_error(png, "not RGB");
        for (int pass = 0; pass < pass_count; ++pass) {
            for (std::size_t y = 0; y < height(); ++y) {
                png_read_row(png, bytes + y * row_size, nullptr);
            }
        }
        png_read_end(png, nullptr);
        return true;
    }
};

/// Keywords of the format begin with a capital letter: `title` becomes the registered "Title".
std::string keyword_of(std::string_view name) {
    std::string keyword(name.substr(0, kMaxKeywordSize));
    if (keyword[0] >= 'a' && keyword[0] <= 'z') {
        keyword[0] = static_cast<char>(keyword[0] - 'a' + 'A');
    }
    return keyword;
}

bool is_ascii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c > 0 && c < 0x7f; });
}

/// The chunks refer to `keywords` and to the texts of `metadata`.
std::vector<png_text> make_texts(Metadata metadata, std::vector<std::string>& keywords) {
    keywords.reserve(metadata.size());
    std::vector<png_text> texts;
    for (const auto& [name, value] : metadata) {
        if (name.empty()) continue;
        keywords.push_back(keyword_of(name));
        png_text text{};
        text.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        text.key = keywords.back().data();
        text.text = const_cast<char*>(value.c_str());  // libpng copies it
        texts.push_back(text);
    }
    return texts;
}

}  // namespace

bool write_png(OutputFile& out, const Image& image, Gamma gamma, Metadata metadata,
               std::string& error, PngBits bits) {
    LRAY_ASSERT(image.width > 0 && image.height > 0);
    std::vector<std::string> keywords;
    std::vector<png_text> texts = make_texts(metadata, keywords);
    const bool is_deep = bits == PngBits::sixteen;
    std::vector<std::uint8_t> row(std::size_t{is_deep ? 6u : 3u} * image.width);
    const auto encode = is_deep ? encode_row_16 : encode_row;

    Writer writer;
    bool is_written =
        writer.open(out) && writer.begin(image.width, image.height, gamma, is_deep ? 16 : 8, texts);
    for (std::size_t y = 0; is_written && y < image.height; ++y) {
        encode(std::span(image.pixels).subspan(y * image.width, image.width), gamma, row);
        is_written = writer.write_row(row.data());
    }
    if (is_written && writer.end()) return true;
    const std::string_view reason = writer.failure.message.data();
    error = !out.error().empty()
                ? out.error()
                : "cannot make a PNG: " + std::string(reason.empty() ? "out of memory" : reason);
    return false;
}

bool is_png(std::span<const std::byte> file) {
    return file.size() >= kSignatureSize &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(file.data()), 0, kSignatureSize) == 0;
}

std::optional<Codes> read_png(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error) {
    if (!is_png(file)) {
        error = "this is not a PNG file";
        return std::nullopt;
    }
    Reader reader(file);
    const auto fail = [&]() -> std::optional<Codes> {
        const char* const message = reader.failure.message.data();
        error = *message != '\0' ? message : "out of memory";
        return std::nullopt;
    };
    if (!reader.open() || !reader.read_header()) return fail();
    if (!limits.allow(reader.width(), reader.height(), error)) return std::nullopt;
    if (reader.least_size() > file.size()) {
        error = "the file ends early";
        return std::nullopt;
    }
    const std::size_t code_count = std::size_t{3} * reader.width() * reader.height();
    if (reader.is_deep()) {
        DeepImage deep{reader.width(), reader.height(), {}};
        deep.rgb.resize(code_count);
        if (!reader.read_rows(reinterpret_cast<std::uint8_t*>(deep.rgb.data()))) return fail();
        return deep;
    }
    CodedImage coded{reader.width(), reader.height(), {}};
    coded.rgb.resize(code_count);
    if (!reader.read_rows(coded.rgb.data())) return fail();
    return coded;
}

}  // namespace lray::image
