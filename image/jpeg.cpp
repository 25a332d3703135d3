// JPEG through libjpeg-turbo, row by row. It reports errors by a callback that must not return: it
// jumps. Each function that calls the library sets its own jump target and holds nothing with a
// destructor while the library runs.
#include "image/jpeg.h"

#include <cstdio>
// jpeglib.h needs stdio's FILE to be known.
#include <fmt/format.h>
#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <string_view>
#include <vector>

#include "base/assert.h"
#include "image/srgb.h"

namespace lray::image {

namespace {

// Encoders make about 10 scans of a progressive picture, and no more than 64 say anything new: each
// of its 3 components comes in at most 2 bands usually, and a bit deeper at most 13 times. Each
// scan costs a pass over all pixels, however few bytes it has.
constexpr int kMaxScans = 64;
// What may be passed over in all: a picture of 2^24 pixels may have all 64 scans, and the largest
// as many as encoders make.
constexpr std::uint64_t kMaxScannedPixels = std::uint64_t{1} << 30;
constexpr int kUsualScans = 16;
constexpr std::size_t kBatchSize = std::size_t{1} << 16;  // bytes handed to the file at a time
constexpr std::size_t kMaxCommentSize = 65533;            // the length field counts itself
constexpr int kSharpColorQuality = 90;
static_assert(kMaxJpegSide == JPEG_MAX_DIMENSION);

/// The first error that was reported; of fixed size, so that no destructor is jumped over.
struct Failure {
    jpeg_error_mgr manager{};  // the library knows the address of this, the first member
    std::jmp_buf target{};
    std::array<char, JMSG_LENGTH_MAX> message{};
    int code = 0;
    int max_scans = kMaxScans;
    bool has_too_many_scans = false;
};

extern "C" {

[[noreturn]] static void on_error(j_common_ptr jpeg) {
    auto& failure = *reinterpret_cast<Failure*>(jpeg->err);
    failure.manager.format_message(jpeg, failure.message.data());
    failure.code = failure.manager.msg_code;
    std::longjmp(failure.target, 1);
}

/// Levels below 0 are warnings: the file is damaged, and the library would make something up.
static void on_message(j_common_ptr jpeg, int level) {
    if (level < 0) on_error(jpeg);
}

/// Called every few rows.
static void on_progress(j_common_ptr jpeg) {
    const auto& decompressor = *reinterpret_cast<jpeg_decompress_struct*>(jpeg);
    auto& failure = *reinterpret_cast<Failure*>(jpeg->err);
    if (decompressor.input_scan_number > failure.max_scans) {
        failure.has_too_many_scans = true;
        on_error(jpeg);
    }
}

}  // extern "C"

jpeg_error_mgr* error_manager(Failure& failure) {
    jpeg_std_error(&failure.manager);
    failure.manager.error_exit = on_error;
    failure.manager.emit_message = on_message;
    return &failure.manager;
}

struct Reader {
    Failure failure{};
    jpeg_progress_mgr progress{};
    jpeg_decompress_struct jpeg{};

    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { jpeg_destroy_decompress(&jpeg); }  // also of one that was never made

    bool read_header(std::span<const std::byte> file) {
        jpeg.err = error_manager(failure);
        if (setjmp(failure.target)) return false;
        jpeg_create_decompress(&jpeg);
        progress.progress_monitor = on_progress;
        jpeg.progress = &progress;
        jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(file.data()), file.size());
        jpeg_read_header(&jpeg, TRUE);
        return true;
    }

    /// Shape: 3 width height bytes.
    bool read_rows(std::uint8_t* bytes) {
        if (setjmp(failure.target)) return false;
        jpeg.out_color_space = JCS_RGB;
        // What gives the same pixels on every processor.
        jpeg.dct_method = JDCT_ISLOW;
        jpeg.do_fancy_upsampling = TRUE;
        jpeg.do_block_smoothing = FALSE;
        jpeg_start_decompress(&jpeg);
        const std::size_t row_size = std::size_t{3} * jpeg.output_width;
        while (jpeg.output_scanline < jpeg.output_height) {
            JSAMPROW row = bytes + jpeg.output_scanline * row_size;
            jpeg_read_scanlines(&jpeg, &row, 1);
        }
        jpeg_finish_decompress(&jpeg);
        return true;
    }

    /// What is wrong, in words.
    std::string reason() const {
        if (failure.has_too_many_scans) {
            return fmt::format("it has more than {} scans, which no {} needs; save it anew",
                               failure.max_scans,
                               failure.max_scans == kMaxScans ? "picture" : "picture of its size");
        }
        switch (failure.code) {
            case JWRN_JPEG_EOF:
            case JERR_INPUT_EOF:
            case JERR_INPUT_EMPTY:
                return "the file ends early";
            default:
                return failure.message.data();
        }
    }
};

/// A file as the library writes to it.
struct Destination {
    jpeg_destination_mgr manager{};  // the library knows the address of this, the first member
    OutputFile* out = nullptr;
    std::array<JOCTET, kBatchSize> batch{};

    void begin() {
        manager.next_output_byte = batch.data();
        manager.free_in_buffer = batch.size();
    }
    bool write(std::size_t size) { return out->write(std::as_bytes(std::span(batch).first(size))); }
};

extern "C" {

static void on_begin(j_compress_ptr jpeg) {
    reinterpret_cast<Destination*>(jpeg->dest)->begin();
}

static boolean on_full(j_compress_ptr jpeg) {
    auto& destination = *reinterpret_cast<Destination*>(jpeg->dest);
    if (!destination.write(destination.batch.size())) ERREXIT(jpeg, JERR_FILE_WRITE);
    destination.begin();
    return TRUE;
}

static void on_end(j_compress_ptr jpeg) {
    auto& destination = *reinterpret_cast<Destination*>(jpeg->dest);
    if (!destination.write(destination.batch.size() - destination.manager.free_in_buffer)) {
        ERREXIT(jpeg, JERR_FILE_WRITE);
    }
}

}  // extern "C"

struct Writer {
    Failure failure{};
    Destination destination{};
    jpeg_compress_struct jpeg{};

    explicit Writer(OutputFile& out) {
        destination.out = &out;
        destination.manager.init_destination = on_begin;
        destination.manager.empty_output_buffer = on_full;
        destination.manager.term_destination = on_end;
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { jpeg_destroy_compress(&jpeg); }

    bool begin(std::uint32_t width, std::uint32_t height, int quality) {
        jpeg.err = error_manager(failure);
        if (setjmp(failure.target)) return false;
        jpeg_create_compress(&jpeg);
        jpeg.dest = &destination.manager;
        jpeg.image_width = width;
        jpeg.image_height = height;
        jpeg.input_components = 3;
        jpeg.in_color_space = JCS_RGB;
        jpeg_set_defaults(&jpeg);
        jpeg_set_quality(&jpeg, quality, TRUE);
        jpeg.dct_method = JDCT_ISLOW;
        jpeg.optimize_coding = TRUE;
        if (quality >= kSharpColorQuality) {
            jpeg.comp_info[0].h_samp_factor = 1;
            jpeg.comp_info[0].v_samp_factor = 1;
        }
        jpeg_start_compress(&jpeg, TRUE);
        return true;
    }

    bool write_comment(std::string_view text) {
        if (setjmp(failure.target)) return false;
        const std::size_t size = std::min(text.size(), kMaxCommentSize);
        jpeg_write_marker(&jpeg, JPEG_COM, reinterpret_cast<const JOCTET*>(text.data()),
                          static_cast<unsigned>(size));
        return true;
    }

    bool write_row(std::uint8_t* bytes) {
        if (setjmp(failure.target)) return false;
        JSAMPROW row = bytes;
        jpeg_write_scanlines(&jpeg, &row, 1);
        return true;
    }

    bool end() {
        if (setjmp(failure.target)) return false;
        jpeg_finish_compress(&jpeg);
        return true;
    }
};

/// How many scans a picture may have. Shape: at least one pixel.
int max_scans(std::uint64_t pixel_count) {
    return static_cast<int>(
        std::clamp<std::uint64_t>(kMaxScannedPixels / pixel_count, kUsualScans, kMaxScans));
}

/// Says why pictures of a kind are not read; empty if they are.
std::string_view refusal_of(J_COLOR_SPACE colors) {
    switch (static_cast<int>(colors)) {
        case JCS_GRAYSCALE:
        case JCS_YCbCr:
        case JCS_RGB:
            return {};
        case JCS_CMYK:
        case JCS_YCCK:
            return "it is in printing inks (CMYK); save it as RGB";
        default:
            return "its colours are neither grey nor RGB; save it as RGB";
    }
}

}  // namespace

bool write_jpeg(OutputFile& out, const Image& image, Gamma gamma, Metadata metadata, int quality,
                std::string& error) {
    LRAY_ASSERT(image.width > 0 && image.height > 0);
    LRAY_ASSERT(quality >= 1 && quality <= 100);
    std::vector<std::uint8_t> row(std::size_t{3} * image.width);

    Writer writer(out);
    bool is_written = writer.begin(image.width, image.height, quality);
    for (const auto& [name, value] : metadata) {
        is_written = is_written && writer.write_comment(name + ": " + value);
    }
    for (std::size_t y = 0; is_written && y < image.height; ++y) {
        encode_row(std::span(image.pixels).subspan(y * image.width, image.width), gamma, row);
        is_written = writer.write_row(row.data());
    }
    if (is_written && writer.end()) return true;
    error = !out.error().empty()
                ? out.error()
                : "cannot make a JPEG: " + std::string(writer.failure.message.data());
    return false;
}

bool is_jpeg(std::span<const std::byte> file) {
    return file.size() >= 3 && file[0] == std::byte{0xff} && file[1] == std::byte{0xd8} &&
           file[2] == std::byte{0xff};
}

std::optional<CodedImage> read_jpeg(std::span<const std::byte> file, const ReadLimits& limits,
                                    std::string& error) {
    if (!is_jpeg(file)) {
        error = "this is not a JPEG file";
        return std::nullopt;
    }
    Reader reader;
    if (!reader.read_header(file)) {
        error = reader.reason();
        return std::nullopt;
    }
    if (const std::string_view refusal = refusal_of(reader.jpeg.jpeg_color_space);
        !refusal.empty()) {
        error = refusal;
        return std::nullopt;
    }
    CodedImage image{reader.jpeg.image_width, reader.jpeg.image_height, {}};
    if (!limits.allow(image.width, image.height, error)) return std::nullopt;
    reader.failure.max_scans = max_scans(std::uint64_t{image.width} * image.height);
    image.rgb.resize(std::size_t{3} * image.width * image.height);
    if (!reader.read_rows(image.rgb.data())) {
        error = reader.reason();
        return std::nullopt;
    }
    return image;
}

}  // namespace lray::image
