// The current directory of a test.
#pragma once

#include <filesystem>
#include <string>

namespace lray::test {

/// Makes a directory the current one as long as it lives.
class CurrentDirectory {
 public:
    explicit CurrentDirectory(const std::string& directory)
        : previous_(std::filesystem::current_path()) {
        std::filesystem::current_path(directory);
    }
    CurrentDirectory(const CurrentDirectory&) = delete;
    CurrentDirectory& operator=(const CurrentDirectory&) = delete;
    ~CurrentDirectory() { std::filesystem::current_path(previous_); }

 private:
    std::filesystem::path previous_;
};

}  // namespace lray::test
