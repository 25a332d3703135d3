// lray-import ENDING BYTES SECONDS: a mesh file on standard input, an answer on standard output.
// lray starts it; it is no program for people.
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <new>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/import/assimp_answer.h"
#include "cli/import/confine.h"

namespace {

std::optional<std::vector<char>> read_input() {
    const off_t end = lseek(STDIN_FILENO, 0, SEEK_END);
    if (end < 0 || lseek(STDIN_FILENO, 0, SEEK_SET) != 0) return {};
    std::vector<char> bytes(static_cast<std::size_t>(end));
    std::size_t size = 0;
    while (size < bytes.size()) {
        const ssize_t read_size = read(STDIN_FILENO, bytes.data() + size, bytes.size() - size);
        if (read_size < 0 && errno == EINTR) continue;
        if (read_size <= 0) return {};
        size += static_cast<std::size_t>(read_size);
    }
    return bytes;
}

int run(std::string_view ending) {
    try {
        const std::optional<std::vector<char>> bytes = read_input();
        return bytes && lray::import::answer(*bytes, ending, STDOUT_FILENO) ? 0 : 1;
    } catch (const std::bad_alloc&) {
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const bool is_confined = lray::import::confine(std::strtoull(argv[2], nullptr, 10),
                                                   std::strtoull(argv[3], nullptr, 10));
    // Nothing is left to tidy up, and what runs at the end of a program may want the system.
    _exit(is_confined ? run(argv[1]) : 3);
}
