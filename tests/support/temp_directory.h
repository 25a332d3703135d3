// A directory that is gone with the test that made it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lray::test {

class TempDirectory {
 public:
    TempDirectory();
    TempDirectory(const TempDirectory&) = delete;
    TempDirectory& operator=(const TempDirectory&) = delete;
    ~TempDirectory();

    const std::string& path() const { return path_; }

    /// The path of a file in it.
    std::string path(std::string_view name) const;

    /// Writes a file, making the directories above it; returns its path.
    std::string write(std::string_view name, std::string_view content) const;

    /// The bytes of a file in it; throws if there is none.
    std::string read(std::string_view name) const;

    /// The names in it, sorted.
    std::vector<std::string> names() const;

 private:
    std::string path_;
};

/// The bytes of a file; throws if there is none.
std::string read_bytes(const std::string& path);

}  // namespace lray::test
