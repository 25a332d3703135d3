// Source: Industrial Light & Magic, "OpenEXR File Layout".
#include "image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace lray::image {

namespace {

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kTiledFlag = 0x200;
constexpr std::uint32_t kDeepFlag = 0x800;
constexpr std::uint32_t kMultiPartFlag = 0x1000;
constexpr std::size_t kMaxNameSize = 255;
constexpr std::size_t kMaxChannels = 64;
// Far from the ends of the numbers, so that sums of corners are right.
constexpr std::int32_t kMostCoordinate = 1 << 29;
// What is unpacked at a time: some lines or tiles side by side.
constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{1} << 28;
// By the number of the packing: none, RLE, ZIP of a line, ZIP, PIZ, PXR24, B44 and B44A.
constexpr std::array<std::uint64_t, 8> kLinesOfChunk = {1, 1, 1, 16, 32, 16, 32, 32};

constexpr std::string_view kDamaged = "the header of the OpenEXR file is damaged";

struct Channel {
    std::string name{};
    std::int32_t type = 0;  // 0: whole numbers, 1: halves, 2: floats
    std::int32_t x_sampling = 1;
    std::int32_t y_sampling = 1;
};

/// Takes numbers and words from bytes; once they are not there, is_good() is false for ever.
class Bytes {
 public:
    explicit Bytes(std::string_view bytes) : rest_(bytes) {}

    bool is_good() const { return is_good_; }
    std::size_t size() const { return rest_.size(); }

    template <class Number>
    Number take() {
        Number number{};
        const std::string_view bytes = take_bytes(sizeof number);
        if (!bytes.empty()) std::memcpy(&number, bytes.data(), sizeof number);
        return number;
    }

    std::string_view take_bytes(std::size_t size) {
        if (size > rest_.size()) {
            is_good_ = false;
            rest_ = {};
            return {};
        }
        const std::string_view taken = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return taken;
    }

    /// A word that ends in a zero.
    std::string_view take_name() {
        const std::size_t end = rest_.substr(0, kMaxNameSize + 1).find('\0');
        if (end == rest_.npos) {
            is_good_ = false;
            return {};
        }
        const std::string_view name = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return name;
    }

 private:
    std::string_view rest_;
    bool is_good_ = true;
};

/// What attributes say of sizes.
struct Layout {
    std::array<std::int32_t, 4> data_window{};  // first x and y, last x and y
    std::vector<Channel> channels{};
    std::uint32_t tile_width = 0;
    std::uint32_t tile_height = 0;
    std::uint8_t compression = 3;  // what the library takes if nothing is said
    bool has_window = false;
};

std::vector<Channel> channels_of(Bytes& value) {
    std::vector<Channel> channels;
    while (channels.size() <= kMaxChannels) {
        Channel channel;
        channel.name = value.take_name();
        if (!value.is_good() || channel.name.empty()) break;
        channel.type = value.take<std::int32_t>();
        value.take_bytes(4);  // hints and what is reserved
        channel.x_sampling = value.take<std::int32_t>();
        channel.y_sampling = value.take<std::int32_t>();
        channels.push_back(std::move(channel));
    }
    return channels;
}

/// Reads the attributes; empty if they are damaged.
std::optional<Layout> read_layout(Bytes& bytes) {
    Layout layout;
    for (;;) {
        const std::string_view name = bytes.take_name();
        if (!bytes.is_good()) return std::nullopt;
        if (name.empty()) return layout;
        const std::string_view type = bytes.take_name();
        const auto size = bytes.take<std::uint32_t>();
        Bytes value(bytes.take_bytes(size));
        if (!bytes.is_good()) return std::nullopt;
        if (name == "dataWindow" && type == "box2i") {
            for (std::int32_t& number : layout.data_window) number = value.take<std::int32_t>();
            layout.has_window = value.is_good();
        } else if (name == "channels" && type == "chlist") {
            layout.channels = channels_of(value);
        } else if (name == "tiles" && type == "tiledesc") {
            layout.tile_width = value.take<std::uint32_t>();
            layout.tile_height = value.take<std::uint32_t>();
        } else if (name == "compression" && type == "compression") {
            layout.compression = value.take<std::uint8_t>();
        }
        if (!value.is_good()) return std::nullopt;
    }
}

const Channel* find_channel(const Layout& layout, std::string_view name) {
    const auto found = std::ranges::find(layout.channels, name, &Channel::name);
    return found == layout.channels.end() ? nullptr : &*found;
}

/// What is wrong with the kind of picture; empty if it is read.
std::string refusal_of(const Layout& layout, ExrHeader& header) {
    constexpr std::uint8_t kDwaa = 8;
    if (layout.compression == kDwaa || layout.compression == kDwaa + 1) {
        return "it is packed by DWA, which processors unpack to different bits; save it with ZIP "
               "or PIZ";
    }
    if (layout.compression >= kLinesOfChunk.size()) {
        return "it is packed in a way that is not known; save it with ZIP or PIZ";
    }
    if (layout.channels.size() > kMaxChannels) {
        return fmt::format("it has more than {} channels; save its colours alone", kMaxChannels);
    }
    const bool has_colors = find_channel(layout, "R") != nullptr &&
                            find_channel(layout, "G") != nullptr &&
                            find_channel(layout, "B") != nullptr;
    if (has_colors) {
        header.channels = {"R", "G", "B"};
    } else if (find_channel(layout, "Y") != nullptr) {
        header.channels = {"Y", "Y", "Y"};
        if (find_channel(layout, "RY") != nullptr || find_channel(layout, "BY") != nullptr) {
            return "its colours are brightness and differences; save it as RGB";
        }
    } else {
        return "it has no channels R, G and B, and no Y";
    }
    for (const Channel& channel : layout.channels) {
        if (channel.x_sampling == 1 && channel.y_sampling == 1) continue;
        return "some of its channels have fewer pixels than others; save it as RGB";
    }
    return {};
}

/// True if nothing that is unpacked at a time is larger than it may be, and the file may hold the
/// places of its chunks.
bool is_affordable(const Layout& layout, const ExrHeader& header, std::size_t rest_size,
                   bool is_tiled) {
    std::uint64_t pixel_size = 0;
    for (const Channel& channel : layout.channels) pixel_size += channel.type == 1 ? 2 : 4;
    const std::uint64_t width = header.width;
    const std::uint64_t height = header.height;
    const std::uint64_t lines = kLinesOfChunk[layout.compression];
    std::uint64_t chunk_bytes = width * lines * pixel_size;
    std::uint64_t chunk_count = (height + lines - 1) / lines;
    if (is_tiled) {
        const std::uint64_t tile_width = layout.tile_width;
        const std::uint64_t tile_height = layout.tile_height;
        constexpr std::uint64_t kMostTileSide = 1 << 14;
        if (tile_width == 0 || tile_height == 0) return false;
        if (tile_width > kMostTileSide || tile_height > kMostTileSide) return false;
        chunk_bytes = (width + tile_width) * tile_height * pixel_size;
        chunk_count =
            ((width + tile_width - 1) / tile_width) * ((height + tile_height - 1) / tile_height);
    }
    return chunk_bytes <= kMaxChunkBytes && chunk_count <= rest_size / sizeof(std::uint64_t);
}

}  // namespace

bool is_exr(std::span<const std::byte> file) {
    std::uint32_t magic = 0;
    if (file.size() < sizeof magic) return false;
    std::memcpy(&magic, file.data(), sizeof magic);
    return magic == kMagic;
}

std::optional<ExrHeader> read_exr_header(std::span<const std::byte> file, const ReadLimits& limits,
                                         std::string& error) {
    if (!is_exr(file)) {
        error = "this is not an OpenEXR file";
        return std::nullopt;
    }
    Bytes bytes({reinterpret_cast<const char*>(file.data()), file.size()});
    bytes.take<std::uint32_t>();
    const auto version = bytes.take<std::uint32_t>();
    if ((version & (kDeepFlag | kMultiPartFlag)) != 0) {
        error = (version & kDeepFlag) != 0
                    ? "it is a deep picture, with several depths in a pixel; save it flat"
                    : "it has several parts; save one alone";
        return std::nullopt;
    }
    const std::optional<Layout> layout = read_layout(bytes);
    if (!layout || !layout->has_window || layout->channels.empty()) {
        error = bytes.is_good() || bytes.size() > 0 ? kDamaged : "the OpenEXR file ends early";
        return std::nullopt;
    }
    ExrHeader header;
    if (error = refusal_of(*layout, header); !error.empty()) return std::nullopt;
    const auto [first_x, first_y, last_x, last_y] = layout->data_window;
    const auto is_near = [](std::int32_t x) { return x > -kMostCoordinate && x < kMostCoordinate; };
    if (!std::ranges::all_of(layout->data_window, is_near) || last_x < first_x ||
        last_y < first_y) {
        error = kDamaged;
        return std::nullopt;
    }
    header.first = {first_x, first_y};
    header.width = static_cast<std::uint32_t>(last_x - first_x + 1);
    header.height = static_cast<std::uint32_t>(last_y - first_y + 1);
    if (!limits.allow(header.width, header.height, error)) return std::nullopt;
    if (!is_affordable(*layout, header, bytes.size(), (version & kTiledFlag) != 0)) {
        error =
            "its lines or tiles are larger than a picture of its size needs, or the OpenEXR "
            "file ends early";
        return std::nullopt;
    }
    return header;
}

}  // namespace lray::image
