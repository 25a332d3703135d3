// In place of exr.cpp where lray is built without OpenEXR (LRAY_EXR).
#include "base/assert.h"
#include "image/exr.h"

namespace lray::image {

bool is_exr_built() {
    return false;
}

bool write_exr(OutputFile&, const Image&, Metadata, std::string&) {
    LRAY_ASSERT(false);  // refused when the format was chosen
}

std::optional<Image> read_exr(std::span<const std::byte>, const ReadLimits&, std::string& error) {
    error = "this lray was built without OpenEXR; save the picture as Radiance HDR or PFM";
    return std::nullopt;
}

}  // namespace lray::image
