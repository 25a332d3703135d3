#include "scene/formats/run_importer.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string>
#include <utility>

#include "base/descriptor.h"

namespace lray::scene {

namespace {

using Clock = std::chrono::steady_clock;

/// Returns the same file under a number above those of the standard streams, which are given away
/// one after the other in the child; it is closed there.
Descriptor above_standard(Descriptor descriptor) {
    if (!descriptor.is_open() || descriptor.fd() > STDERR_FILENO) return descriptor;
    return Descriptor(fcntl(descriptor.fd(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

/// Returns a file in memory that holds the bytes and can change no more.
Descriptor make_input(std::string_view bytes) {
    Descriptor file =
        above_standard(Descriptor(memfd_create("mesh", MFD_CLOEXEC | MFD_ALLOW_SEALING)));
    while (file.is_open() && !bytes.empty()) {
        const ssize_t written = write(file.fd(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return {};
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (!file.is_open()) return {};
    const bool is_ready = fcntl(file.fd(), F_ADD_SEALS,
                                F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) == 0 &&
                          lseek(file.fd(), 0, SEEK_SET) == 0;
    return is_ready ? std::move(file) : Descriptor{};
}

/// What posix_spawn() is told; freed again.
class SpawnPlan {
 public:
    SpawnPlan(int input, int output) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        sigset_t none;
        sigset_t all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &all);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }

    /// Returns the number of the process; -1 if it could not be started.
    pid_t start(char* const* arguments) const {
        std::array<char*, 1> environment = {nullptr};
        pid_t pid = -1;
        const int error =
            posix_spawn(&pid, arguments[0], &actions_, &attributes_, arguments, environment.data());
        return error == 0 ? pid : -1;
    }

 private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// A process that ends with this object, if not before.
class Child {
 public:
    explicit Child(pid_t pid) : pid_(pid) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() { kill_now(); }

    /// Waits for its end. False: it is still running at the deadline.
    bool wait_until(Clock::time_point deadline) {
        for (;;) {
            const pid_t ended = waitpid(pid_, &status_, WNOHANG);
            // Where ended processes are not kept (SIGCHLD ignored) the answer alone is judged.
            const bool is_unknown = ended < 0 && errno == ECHILD;
            if (ended == pid_ || is_unknown) {
                pid_ = -1;
                return true;
            }
            if (Clock::now() >= deadline) return false;
            constexpr int kStepMs = 1;  // it has closed its output, so it is about to end
            poll(nullptr, 0, kStepMs);
        }
    }

    void kill_now() {
        if (pid_ < 0) return;
        kill(pid_, SIGKILL);
        while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
    }

    int status() const { return status_; }

 private:
    pid_t pid_;
    int status_ = 0;
};

enum class Reading : std::uint8_t { ended, out_of_time, too_much };

Reading read_answer(int pipe, std::uint64_t max_size, Clock::time_point deadline,
                    std::vector<char>& answer) {
    std::vector<char> chunk(std::size_t{1} << 16);
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) return Reading::out_of_time;
        constexpr std::int64_t kLongest = 1000;  // then the time is looked at again
        pollfd event{pipe, POLLIN, 0};
        if (poll(&event, 1, static_cast<int>(std::min<std::int64_t>(left, kLongest))) <= 0) {
            continue;
        }
        const ssize_t size = read(pipe, chunk.data(), chunk.size());
        if (size < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (size <= 0) return Reading::ended;
        if (answer.size() + static_cast<std::size_t>(size) > max_size) return Reading::too_much;
        answer.insert(answer.end(), chunk.begin(), chunk.begin() + size);
    }
}

ImporterEnd end_of(int status) {
    if (WIFEXITED(status)) {
        return WEXITSTATUS(status) == 0 ? ImporterEnd::answered : ImporterEnd::failed;
    }
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU) return ImporterEnd::out_of_time;
    return signal == SIGSYS ? ImporterEnd::forbidden : ImporterEnd::crashed;
}

}  // namespace

ImporterRun run_importer(const ImportSettings& settings, std::string_view ending,
                         std::string_view bytes) {
    std::array<int, 2> ends = {-1, -1};
    const Descriptor input = make_input(bytes);
    if (!input.is_open() || pipe2(ends.data(), O_CLOEXEC) != 0) {
        return {ImporterEnd::not_started, {}};
    }
    const Descriptor output = above_standard(Descriptor(ends[0]));
    Descriptor child_output = above_standard(Descriptor(ends[1]));
    if (!output.is_open() || !child_output.is_open()) return {ImporterEnd::not_started, {}};

    std::array<std::string, 4> words = {settings.program, std::string(ending),
                                        std::to_string(settings.bytes),
                                        std::to_string(settings.seconds)};
    std::array<char*, 5> arguments = {words[0].data(), words[1].data(), words[2].data(),
                                      words[3].data(), nullptr};
    const auto deadline = Clock::now() + std::chrono::seconds(settings.seconds);
    const pid_t pid = SpawnPlan(input.fd(), child_output.fd()).start(arguments.data());
    if (pid < 0) return {ImporterEnd::not_started, {}};
    Child child(pid);
    child_output.close();

    ImporterRun run;
    switch (read_answer(output.fd(), settings.bytes, deadline, run.answer)) {
        case Reading::ended:
            break;
        case Reading::out_of_time:
            run.end = ImporterEnd::out_of_time;
            return run;
        case Reading::too_much:
            run.end = ImporterEnd::too_much;
            return run;
    }
    run.end = child.wait_until(deadline) ? end_of(child.status()) : ImporterEnd::out_of_time;
    return run;
}

}  // namespace lray::scene
