// Runs the importing program on the bytes of a file.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/formats/import_mesh.h"

namespace lray::scene {

enum class ImporterEnd : std::uint8_t {
    answered,   // it ended by itself, with 0
    failed,     // it ended by itself, with another number
    crashed,    // a signal ended it
    forbidden,  // it did what it may not do
    out_of_time,
    too_much,  // it wrote more than it may have memory
    not_started,
};

struct ImporterRun {
    ImporterEnd end{};
    std::vector<char> answer{};
};

/// Runs the program with the bytes as its standard input, a pipe as its standard output and nothing
/// else of this process. It is a new program rather than a fork of this one: other threads may hold
/// locks, of memory too, that a fork never gets back. It is gone when this returns.
ImporterRun run_importer(const ImportSettings& settings, std::string_view ending,
                         std::string_view bytes);

}  // namespace lray::scene
