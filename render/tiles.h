// How work on a picture is shared among threads: tiles, made of blocks.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>

namespace lray::render {

inline constexpr std::uint32_t kTileSize = 16;  // pixels a side, what a thread takes at a time
inline constexpr std::uint32_t kBlockSize = 8;  // whose rays are traced together

/// Calls work(i) for each tile below a count, on all threads.
template <class Work>
void for_each_tile(std::uint64_t tile_count, const Work& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::uint64_t>(0, tile_count),
        [&](const tbb::blocked_range<std::uint64_t>& range) {
            for (std::uint64_t tile = range.begin(); tile != range.end(); ++tile) work(tile);
        },
        tbb::simple_partitioner());
}

}  // namespace lray::render
