// How the program ends, and what it says when it cannot go on.
#pragma once

#include <cstdint>
#include <string>

namespace lray::cli {

enum class ExitCode : std::uint8_t {
    done = 0,
    scene = 1,    // an error in the scene or a file it names
    usage = 2,    // a wrong command line
    limit = 3,    // a limit, or memory
    output = 4,   // the output could not be written
    window = 5,   // no display or no OpenGL for the window
    unbuilt = 5,  // what was left out when lray was built
    internal = 70,
    interrupted = 130,
    terminated = 143,
};

/// Why there is no picture: one sentence, and what to do about it.
struct Failure {
    ExitCode exit_code = ExitCode::usage;
    std::string message{};
    std::string help{};
};

}  // namespace lray::cli
