#include "image/ppm.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "image/netpbm_header.h"
#include "image/srgb.h"

namespace lray::image {

namespace {

constexpr std::size_t kBatchSize = std::size_t{1} << 16;  // bytes handed to the file at a time
constexpr std::uint32_t kMostMaximum = 65535;

struct Header {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t maximum = 0;
    std::uint64_t channel_count = 3;  // in the file
    bool is_binary = true;

    std::uint64_t sample_count() const { return channel_count * width * height; }
};

/// Hands each sample of a binary file to `put`; those beyond the maximum are the maximum.
/// Shape: as many samples as the bytes hold.
template <class Put>
void each_sample(const Header& header, std::string_view bytes, const Put& put) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    const std::uint64_t count = header.sample_count();
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint32_t sample =
            header.maximum < 256 ? byte(i) : std::uint32_t{byte(2 * i)} * 256u + byte(2 * i + 1);
        put(std::min(sample, header.maximum));
    }
}

/// Adds samples as codes from 0 to `most`, greys three times.
template <class Code>
class CodeAdder {
 public:
    CodeAdder(const Header& header, Code most, std::vector<Code>& rgb)
        : header_(header), most_(most), rgb_(rgb) {
        rgb_.reserve(std::size_t{3} * header.width * header.height);
    }

    void operator()(std::uint32_t sample) const {
        const std::uint32_t code = (sample * most_ + header_.maximum / 2) / header_.maximum;
        rgb_.insert(rgb_.end(), header_.channel_count == 1 ? 3 : 1, static_cast<Code>(code));
    }

 private:
    const Header& header_;
    std::uint32_t most_;
    std::vector<Code>& rgb_;
};

/// Reads the samples, whose size is known to be there. Empty: `error` tells why.
template <class Picture>
std::optional<Codes> read_samples(const Header& header, NetpbmHeader& file, std::string& error) {
    Picture picture{header.width, header.height, {}};
    using Code = typename decltype(picture.rgb)::value_type;
    const CodeAdder<Code> add(header, std::numeric_limits<Code>::max(), picture.rgb);
    if (header.is_binary) {
        each_sample(header, *file.take_pixels(), add);
        return picture;
    }
    for (std::uint64_t i = 0; i < header.sample_count(); ++i) {
        const auto sample = file.take_number<std::uint32_t>();
        if (!sample) {
            error = file.rest_size() == 0
                        ? fmt::format("the PPM file ends early: {} of {} numbers of pixels", i,
                                      header.sample_count())
                        : std::string("among the numbers of the PPM file is something else");
            return std::nullopt;
        }
        add(std::min(*sample, header.maximum));
    }
    return picture;
}

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

bool is_ppm(std::span<const std::byte> file) {
    if (file.size() < 2 || file[0] != std::byte{'P'}) return false;
    const char kind = static_cast<char>(file[1]);
    return kind == '2' || kind == '3' || kind == '5' || kind == '6';
}

std::optional<Codes> read_ppm(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error) {
    if (!is_ppm(file)) {
        error = "this is not a PPM or PGM (P6, P5, P3, P2) file";
        return std::nullopt;
    }
    NetpbmHeader reader(file);
    reader.skip_magic();
    const char kind = static_cast<char>(file[1]);
    const auto width = reader.take_number<std::uint32_t>();
    const auto height = reader.take_number<std::uint32_t>();
    const auto maximum = reader.take_number<std::uint32_t>();
    const auto pixels = reader.take_pixels();
    if (!width || !height || !maximum || !pixels || *width == 0 || *height == 0) {
        error = "the PPM header needs a width, a height and a maximum";
        return std::nullopt;
    }
    const Header header{*width, *height, *maximum, kind == '3' || kind == '6' ? 3u : 1u,
                        kind >= '5'};
    if (header.maximum == 0 || header.maximum > kMostMaximum) {
        error = fmt::format("the PPM maximum is {}; it is 1 to {}", header.maximum, kMostMaximum);
        return std::nullopt;
    }
    if (!limits.allow(header.width, header.height, error)) return std::nullopt;
    const std::uint64_t sample_size = header.maximum < 256 ? 1 : 2;
    // A number and what divides it from the next take two characters, but the last one.
    const std::uint64_t needed =
        header.is_binary ? sample_size * header.sample_count() : 2 * header.sample_count() - 1;
    if (pixels->size() < needed) {
        error = fmt::format("the PPM file ends early: {} of {} bytes of pixels", pixels->size(),
                            needed);
        return std::nullopt;
    }
    return sample_size == 1 ? read_samples<CodedImage>(header, reader, error)
                            : read_samples<DeepImage>(header, reader, error);
}

}  // namespace lray::image
