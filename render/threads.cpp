#include "render/threads.h"

#include <tbb/info.h>

namespace lray::render {

std::uint32_t thread_count_of(std::uint32_t asked) {
    return asked != 0 ? asked : static_cast<std::uint32_t>(tbb::info::default_concurrency());
}

}  // namespace lray::render
