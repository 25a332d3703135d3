// Stands in for lray-import, and does what the file that it is given says: all that a broken or
// taken over importer might.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "cli/import/confine.h"
#include "scene/formats/import_wire.h"

namespace {

namespace wire = lray::scene::wire;

void add(std::string& out, std::uint32_t word) {
    out.append(reinterpret_cast<const char*>(&word), sizeof word);
}

int send(const std::string& text) {
    return write(STDOUT_FILENO, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0
                                                                                               : 1;
}

/// An answer that says this is why there is no mesh.
int say(std::string_view reason) {
    std::string out;
    add(out, wire::kMagic);
    add(out, wire::kFailure);
    add(out, static_cast<std::uint32_t>(wire::Failure::not_understood));
    add(out, static_cast<std::uint32_t>(reason.size()));
    return send(out.append(reason));
}

[[noreturn]] void hang() {
    for (;;) {
        volatile int nothing = 0;
        (void)nothing;
    }
}

int act(std::string_view what) {
    if (what == "exit") return 3;
    if (what == "crash") {
        std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would tell of it first, by forbidden calls
        std::raise(SIGSEGV);
    }
    if (what == "abort") std::abort();
    if (what == "hang") hang();
    if (what == "silence") return 0;
    if (what == "garbage") return send("solid nonsense");
    if (what == "endless") {
        const std::string much(std::size_t{1} << 16, 'x');
        while (send(much) == 0) {
        }
    }
    if (what == "close and hang") {
        close(STDOUT_FILENO);
        hang();
    }
    if (what == "memory") {
        constexpr std::size_t kMuch = std::size_t{1} << 40;
        return say(mmap(nullptr, kMuch, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED
                       ? "has a limit"
                       : "has no limit");
    }
    if (what == "files") {
        std::string found;
        for (const char* path : {"/etc/passwd", "/dev/null", "/proc/self/maps", "."}) {
            if (open(path, O_RDONLY) >= 0) found += std::string("opened ") + path + "; ";
        }
        if (open("/tmp/lray-hostile", O_WRONLY | O_CREAT, 0600) >= 0) found += "made a file; ";
        return say(found.empty() ? "reaches nothing" : found);
    }
    if (what == "descriptors") {
        std::string found;
        for (int fd = STDERR_FILENO + 1; fd < 200; ++fd) {
            char byte = 0;
            if (read(fd, &byte, 1) >= 0 || errno != EBADF) found += std::to_string(fd) + " ";
        }
        return say(found.empty() ? "has none" : found);
    }
    if (what == "socket") return say(socket(AF_INET, SOCK_STREAM, 0) >= 0 ? "connects" : "none");
    if (what == "process") return say(fork() >= 0 ? "multiplies" : "alone");
    if (what == "code") {
        return say(mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED
                       ? "none"
                       : "makes code");
    }
    return say("\x1b[2J");
}

}  // namespace

int main(int argc, char** argv) {
    std::array<char, 100> bytes{};
    const ssize_t size = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (argc != 4 || size < 0) return 2;
    if (!lray::import::confine(std::strtoull(argv[2], nullptr, 10),
                               std::strtoull(argv[3], nullptr, 10))) {
        return 4;
    }
    _exit(act({bytes.data(), static_cast<std::size_t>(size)}));
}
