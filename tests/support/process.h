// Runs a program and catches what it says.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/temp_directory.h"

namespace lray::test {

struct ProcessResult {
    int exit_code = -1;  // 128 + the signal's number if one ended it, as shells count
    std::string out{};
    std::string err{};
};

/// A program that was started. Its input is empty or a text; it is killed after two minutes.
class Process {
 public:
    /// command[0] is the path of the program; `directory` is where it runs.
    explicit Process(const std::vector<std::string>& command, std::string_view input = {},
                     const std::string& directory = ".");
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process();

    void send_signal(int number) const;

    /// What it has said so far.
    std::string out() const;
    std::string err() const;

    /// True as long as it has not ended.
    bool is_running();

    /// Processor seconds it has used so far.
    double cpu_seconds() const;

    /// Waits for its end.
    ProcessResult wait();

 private:
    TempDirectory files_;
    int id_ = -1;
    std::optional<int> status_{};  // of its end, if that was noticed already
};

/// Starts a program and waits for its end.
ProcessResult run_process(const std::vector<std::string>& command, std::string_view input = {},
                          const std::string& directory = ".");

}  // namespace lray::test
