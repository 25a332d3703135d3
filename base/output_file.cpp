#include "base/output_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <utility>
#include <vector>

#include "base/descriptor.h"
#include "base/nearby_files.h"
#include "base/path.h"

namespace lray {
namespace {

constexpr std::string_view kTemporaryMark = ".lray-tmp.";

/// Returns the file a path means after following the links at its end, or the path of the missing
/// file the last link points to.
std::string follow_links(std::string path) {
    constexpr int kMaxLinks = 40;  // as Linux has it
    for (int i = 0; i < kMaxLinks; ++i) {
        std::array<char, 4096> buffer{};
        const ssize_t length = ::readlink(path.c_str(), buffer.data(), buffer.size());
        if (length <= 0) break;
        const std::string_view target(buffer.data(), static_cast<std::size_t>(length));
        // Put together as text, unchanged: "x/.." may not be tidied away where x is a link.
        path = target.starts_with('/') ? std::string(target)
                                       : fmt::format("{}/{}", directory_of(path), target);
    }
    return path;
}

std::optional<int> parse_number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole = error == std::errc{} && end == text.data() + text.size();
    return is_whole && value >= 0 ? std::optional<int>(value) : std::nullopt;
}

/// Returns the descriptor that a path like /dev/stdout names: it is written as it is, even if the
/// shell made it a regular file.
std::optional<int> named_descriptor(std::string_view path) {
    if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view directory : {"/dev/fd/", "/proc/self/fd/"}) {
        if (path.starts_with(directory)) return parse_number(path.substr(directory.size()));
    }
    return std::nullopt;
}

/// Returns the process id in ".image.png.lray-tmp.<pid>.<n>"; empty for any other name.
std::optional<int> process_of_temporary(std::string_view name) {
    const std::size_t mark = name.rfind(kTemporaryMark);
    if (!name.starts_with('.') || mark == std::string_view::npos) return std::nullopt;
    const std::string_view numbers = name.substr(mark + kTemporaryMark.size());
    const std::size_t dot = numbers.find('.');
    if (dot == std::string_view::npos || !parse_number(numbers.substr(dot + 1))) {
        return std::nullopt;
    }
    return parse_number(numbers.substr(0, dot));
}

/// Removes the temporaries of processes that are gone. The process must be unknown here and its
/// lock free: either alone may mislead (another machine's process, a file not yet locked).
void sweep_temporaries(int directory) {
    for (const std::string& name :
         names_in(Descriptor(openat(directory, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)))) {
        const std::optional<int> process = process_of_temporary(name);
        if (!process || *process <= 0 || kill(*process, 0) == 0 || errno != ESRCH) continue;
        const Descriptor file(
            openat(directory, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
        struct stat status {};
        const bool is_ours = file.is_open() && fstat(file.fd(), &status) == 0 &&
                             S_ISREG(status.st_mode) && status.st_uid == geteuid();
        if (is_ours && flock(file.fd(), LOCK_EX | LOCK_NB) == 0) {
            unlinkat(directory, name.c_str(), 0);
        }
    }
}

}  // namespace

struct OutputFile::State {
    std::string shown{};  // as the user named it
    Descriptor file{};
    Descriptor directory{};   // none when written directly
    std::string name{};       // in the directory
    std::string temporary{};  // in the directory; empty when there is none (any more)
    std::string buffer{};
    std::string error{};

    ~State() { remove_temporary(); }

    bool fail(const std::string& why) {
        if (error.empty()) error = fmt::format("cannot write `{}`: {}", shown, why);
        remove_temporary();
        return false;
    }

    void remove_temporary() {
        if (!temporary.empty()) unlinkat(directory.fd(), temporary.c_str(), 0);
        temporary.clear();
    }

    bool write_out(const char* bytes, std::size_t size);
    bool flush();
    bool create_temporary();
};

bool OutputFile::State::write_out(const char* bytes, std::size_t size) {
    while (size > 0) {
        const ssize_t count = ::write(file.fd(), bytes, size);
        if (count >= 0) {
            bytes += count;
            size -= static_cast<std::size_t>(count);
        } else if (errno == EPIPE) {
            return fail("its reader has gone away");
        } else if (errno == EAGAIN) {  // a pipe that its other end made non-blocking
            pollfd waiting{file.fd(), POLLOUT, 0};
            poll(&waiting, 1, -1);
        } else if (errno != EINTR) {
            return fail(error_words(errno));
        }
    }
    return true;
}

bool OutputFile::State::flush() {
    const bool is_written = write_out(buffer.data(), buffer.size());
    buffer.clear();
    return is_written;
}

bool OutputFile::State::create_temporary() {
    // Names are unique in this process; a file of that name is another's, of an equal process id.
    static std::atomic<unsigned> next_number{0};
    constexpr int kMaxTries = 1000;
    constexpr std::size_t kMaxStem = 200;  // of the 255 bytes a name may have
    for (int i = 0; i < kMaxTries; ++i) {
        temporary =
            fmt::format(".{:.{}}{}{}.{}", name, kMaxStem, kTemporaryMark, getpid(), next_number++);
        file = Descriptor(openat(directory.fd(), temporary.c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
        if (file.is_open()) {
            flock(file.fd(), LOCK_EX | LOCK_NB);  // where it fails, the sweep leaves the file alone
            return true;
        }
        if (errno != EEXIST) break;
    }
    temporary.clear();
    return false;
}

std::optional<OutputFile> OutputFile::open(const std::string& path, std::string& error) {
    auto state = std::make_unique<State>();
    state->shown = path;
    const auto refuse = [&](const std::string& why) {
        state->fail(why);
        error = state->error;
        return std::nullopt;
    };
    if (const std::optional<int> descriptor = named_descriptor(path)) {
        state->file = Descriptor(fcntl(*descriptor, F_DUPFD_CLOEXEC, 0));
        if (!state->file.is_open()) return refuse(error_words(errno));
        return OutputFile(std::move(state));
    }
    if (path.empty() || path.find('\0') != std::string::npos) return refuse("this is no file name");

    struct stat old {};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT) return refuse(error_words(errno));
    if (path.ends_with('/') || (exists && S_ISDIR(old.st_mode))) return refuse("it is a directory");
    if (exists && !S_ISREG(old.st_mode)) {
        state->file = Descriptor(::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
        if (!state->file.is_open()) return refuse(error_words(errno));
        return OutputFile(std::move(state));
    }

    const std::string target = follow_links(path);
    const std::string directory = directory_of(target);
    state->name = file_name_of(target);
    state->directory = Descriptor(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!state->directory.is_open()) {
        return refuse(errno == ENOENT
                          ? fmt::format("there is no directory `{}`", directory)
                          : fmt::format("directory `{}`: {}", directory, error_words(errno)));
    }
    // A file that may not be written is not replaced either.
    if (exists && faccessat(state->directory.fd(), state->name.c_str(), W_OK, AT_EACCESS) != 0) {
        return refuse(error_words(errno));
    }
    sweep_temporaries(state->directory.fd());
    if (!state->create_temporary()) {
        return refuse(fmt::format("directory `{}`: {}", directory, error_words(errno)));
    }
    if (exists) {
        // Best effort: the picture is worth more than its owner. The owner first, as a change of
        // owner may reset the mode.
        if (fchown(state->file.fd(), old.st_uid, old.st_gid) != 0) {
            static_cast<void>(fchown(state->file.fd(), static_cast<uid_t>(-1), old.st_gid) == 0);
        }
        static_cast<void>(fchmod(state->file.fd(), old.st_mode & 0777) == 0);
    }
    return OutputFile(std::move(state));
}

OutputFile::OutputFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

bool OutputFile::write(std::span<const std::byte> bytes) {
    return write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

bool OutputFile::write(std::string_view text) {
    constexpr std::size_t kBufferSize = std::size_t{1} << 16;
    if (!state_->error.empty()) return false;
    if (state_->buffer.size() + text.size() > kBufferSize && !state_->flush()) return false;
    if (text.size() > kBufferSize) return state_->write_out(text.data(), text.size());
    state_->buffer += text;
    return true;
}

bool OutputFile::commit() {
    State& state = *state_;
    if (!state.error.empty() || !state.flush()) return false;
    // Pipes and terminals cannot be synchronised (EINVAL, EROFS), and need not be.
    if (fsync(state.file.fd()) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) {
        return state.fail(error_words(errno));
    }
    if (!state.file.close()) return state.fail(error_words(errno));
    if (state.temporary.empty()) return true;
    const int directory = state.directory.fd();
    if (renameat(directory, state.temporary.c_str(), directory, state.name.c_str()) != 0) {
        return state.fail(error_words(errno));
    }
    state.temporary.clear();
    // So that the new name survives a power cut, too; where that is not possible, it is written.
    static_cast<void>(fsync(directory) == 0);
    return true;
}

const std::string& OutputFile::error() const {
    return state_->error;
}

}  // namespace lray
