// Fuzzes the readers that are all our own: Radiance HDR, PFM, PPM and PGM.
#include <cstddef>
#include <cstdint>
#include <span>

#include "tests/fuzz/fuzz_picture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lray::fuzz::read_picture(std::as_bytes(std::span(data, size)));
    return 0;
}
