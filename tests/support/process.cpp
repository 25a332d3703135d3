#include "tests/support/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sstream>
#include <stdexcept>

namespace lray::test {

namespace {

constexpr unsigned kTimeLimitSeconds = 120;

void redirect(int target, const std::string& path, int flags) {
    const int file = open(path.c_str(), flags, 0600);
    if (file < 0 || dup2(file, target) < 0) _exit(126);
    close(file);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, std::string_view input,
                 const std::string& directory) {
    const std::string in = files_.write("in", input);
    const std::string out = files_.write("out", "");
    const std::string err = files_.write("err", "");
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    id_ = fork();
    if (id_ < 0) throw std::runtime_error("fork failed");
    if (id_ > 0) return;
    redirect(STDIN_FILENO, in, O_RDONLY);
    redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT);
    if (chdir(directory.c_str()) != 0) _exit(126);
    alarm(kTimeLimitSeconds);  // outlives exec
    execv(arguments[0], arguments.data());
    _exit(127);
}

Process::~Process() {
    if (id_ < 0 || status_) return;
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
}

void Process::send_signal(int number) const {
    if (id_ > 0) kill(id_, number);
}

std::string Process::out() const {
    return files_.read("out");
}

std::string Process::err() const {
    return files_.read("err");
}

bool Process::is_running() {
    if (id_ < 0 || status_) return false;
    int status = 0;
    if (waitpid(id_, &status, WNOHANG) == id_) status_ = status;
    return !status_;
}

double Process::cpu_seconds() const {
    // The 14th and 15th field are user and system time; the second is a name in parentheses.
    const std::string stat = read_bytes("/proc/" + std::to_string(id_) + "/stat");
    std::istringstream fields(stat.substr(stat.rfind(')') + 2));
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    double user = 0.0;
    double system = 0.0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

ProcessResult Process::wait() {
    int status = status_.value_or(0);
    if (id_ < 0 || (!status_ && waitpid(id_, &status, 0) != id_)) {
        throw std::runtime_error("nothing to wait for");
    }
    id_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out(), err()};
}

ProcessResult run_process(const std::vector<std::string>& command, std::string_view input,
                          const std::string& directory) {
    return Process(command, input, directory).wait();
}

}  // namespace lray::test
