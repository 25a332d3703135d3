// OpenEXR through its own library, from and to memory. It throws: what it throws is caught here.
#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "base/assert.h"
#include "image/exr_header.h"

namespace lray::image {

namespace {

static_assert(sizeof(Color) == 3 * sizeof(float));
constexpr std::array<const char*, 3> kChannels = {"R", "G", "B"};
// Names of other types that a file in lines need not have: as text, readers take them as damage.
constexpr std::array<std::string_view, 4> kNamesOfFormat = {"chunkCount", "tiles", "type",
                                                            "version"};

/// A file in memory, as the library reads it.
class MemoryInput final : public Imf::IStream {
 public:
    explicit MemoryInput(std::span<const std::byte> file) : Imf::IStream("picture"), file_(file) {}

    bool read(char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(std::max(count, 0));
        if (at_ > file_.size() || size > file_.size() - at_) {
            throw std::runtime_error("the OpenEXR file ends early");
        }
        if (size > 0) std::memcpy(bytes, file_.data() + at_, size);
        at_ += size;
        return at_ < file_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override { at_ = at; }

 private:
    std::span<const std::byte> file_;
    std::uint64_t at_ = 0;
};

/// A file in memory, as the library writes it: it goes back to note where lines begin, which what
/// is written to may not allow.
class MemoryOutput final : public Imf::OStream {
 public:
    MemoryOutput() : Imf::OStream("picture") {}

    void write(const char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(std::max(count, 0));
        if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
        std::copy_n(bytes, size, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ += size;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = at; }

    std::string_view bytes() const { return bytes_; }

 private:
    std::string bytes_{};
    std::size_t at_ = 0;
};

/// Channels of a picture in memory. The library counts from the origin, not from the window: the
/// base may lie far outside of the pixels, so it is worked out in whole numbers.
Imf::FrameBuffer frame_buffer(const Color* pixels, std::uint32_t width, const ExrHeader& header) {
    Imf::FrameBuffer buffer;
    const std::size_t row_size = std::size_t{width} * sizeof(Color);
    const std::int64_t before =
        std::int64_t{header.first[1]} * static_cast<std::int64_t>(row_size) +
        std::int64_t{header.first[0]} * static_cast<std::int64_t>(sizeof(Color));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto first = reinterpret_cast<std::uintptr_t>(pixels) + i * sizeof(float);
        const std::uintptr_t base = first - static_cast<std::uintptr_t>(before);
        buffer.insert(header.channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base),
                                                     sizeof(Color), row_size));
    }
    return buffer;
}

std::string bytes_of(const Image& image, Metadata metadata) {
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* const channel : kChannels) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [name, value] : metadata) {
        // The names that the format itself uses have other types.
        const bool is_free = !name.empty() && header.find(name) == header.end() &&
                             std::ranges::find(kNamesOfFormat, name) == kNamesOfFormat.end();
        if (is_free) header.insert(name, Imf::StringAttribute(value));
    }
    MemoryOutput output;
    {
        Imf::OutputFile file(output, header, 0);
        const ExrHeader layout{{}, image.width, image.height, {"R", "G", "B"}};
        file.setFrameBuffer(frame_buffer(image.pixels.data(), image.width, layout));
        file.writePixels(static_cast<int>(image.height));
    }
    return std::string(output.bytes());
}

void read_pixels(std::span<const std::byte> bytes, const ExrHeader& header, Image& image) {
    MemoryInput input(bytes);
    Imf::InputFile file(input, 0);
    const Imath::Box2i window = file.header().dataWindow();
    const bool is_as_looked_through =
        window.min.x == header.first[0] && window.min.y == header.first[1] &&
        window.max.x - window.min.x + 1 == static_cast<int>(header.width) &&
        window.max.y - window.min.y + 1 == static_cast<int>(header.height);
    if (!is_as_looked_through) throw std::runtime_error("its data window is given twice");
    file.setFrameBuffer(frame_buffer(image.pixels.data(), image.width, header));
    file.readPixels(window.min.y, window.max.y);
    if (header.channels[0] == header.channels[1]) {
        for (Color& pixel : image.pixels) pixel = Color{pixel.b};
    }
}

}  // namespace

bool is_exr_built() {
    return true;
}

bool write_exr(OutputFile& out, const Image& image, Metadata metadata, std::string& error) {
    LRAY_ASSERT(image.width > 0 && image.height > 0);
    std::string bytes;
    try {
        bytes = bytes_of(image, metadata);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& thrown) {
        error = std::string("cannot make an OpenEXR file: ") + thrown.what();
        return false;
    }
    if (out.write(bytes)) return true;
    error = out.error();
    return false;
}

std::optional<Image> read_exr(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error) {
    const std::optional<ExrHeader> header = read_exr_header(file, limits, error);
    if (!header) return std::nullopt;
    try {
        Image image(header->width, header->height);
        read_pixels(file, *header, image);
        return image;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& thrown) {
        error = thrown.what();
        return std::nullopt;
    }
}

}  // namespace lray::image
