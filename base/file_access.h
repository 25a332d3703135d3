// The one way to open a file for reading: access policy, the bundled library, size bounds, and the
// list of what was read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "base/content_hash.h"
#include "base/descriptor.h"
#include "base/open_beneath.h"
#include "base/source.h"

namespace lray {

enum class ReadStatus : std::uint8_t {
    ok,
    not_found,
    outside,      // exists or not, it is not under any allowed directory
    not_regular,  // a directory, device, FIFO or socket
    too_large,
    unreadable,  // permission or an I/O error: see `reason`
};

struct ReadResult {
    ReadStatus status = ReadStatus::not_found;
    std::string path{};  // as shown to the user: where it was found, or the first place searched
    std::string directory{};  // of the file found: what is written inside it is relative to this
    std::string identity{};   // of a regular file: the same however it was named
    Text text{};
    std::string reason{};                  // errno in words, for `unreadable`
    std::vector<std::string> searched{};   // paths tried, in order
    std::string nearest{};                 // the path as it might have been meant; may be empty
    bool used_backslash = false;           // `\` was read as `/` (W1603)
    bool differs_in_case = false;          // found only by ignoring case (W1604): see `path`
    bool is_absolute = false;              // W1605
    std::string allow{};                   // for `outside`: the directory to name with --allow
    bool is_library = false;               // `std:` was named, or a file of it named another
    std::vector<std::string> available{};  // for `not_found` in the library: what is there
};

/// Reads files for a scene from a stranger: only regular files under the allowed directories,
/// decided on the descriptor (openat2 with RESOLVE_BENEATH and RESOLVE_NO_MAGICLINKS; without
/// openat2 a component-wise walk with O_NOFOLLOW), opened with O_NONBLOCK.
class FileAccess {
 public:
    /// Files that are missing: for so many, directories are searched for what was meant. A scene
    /// may name any number of missing files.
    static constexpr std::size_t kMaxSearches = 100;

    /// So many missing files are remembered.
    static constexpr std::size_t kMaxFilesMissed = 1000;

    explicit FileAccess(BeneathMethod method = best_beneath_method()) : method_(method) {}

    /// Reads may touch this directory and all below it. Also a place where relative names are
    /// searched if `is_searched` (-I, LRAY_PATH).
    void allow(std::string directory, bool is_searched);

    /// The directory of the bundled library, for names that begin with `std:`. They are searched
    /// nowhere else, and no other name leads there.
    void set_library(const std::string& directory);

    /// Reads the main file, named by the user on the command line: any place, "-" is stdin (shown
    /// as "<stdin>"). Its directory becomes allowed; of what is not a regular file (stdin, FIFOs
    /// and devices are accepted here), the current one. It may be larger than a source: films are.
    ReadResult read_main(std::string_view path, std::uint64_t max_size);

    /// Reads a file named inside another: relative to `from_directory`, then to each searched
    /// directory in the order given. Neither "x/.." nor the letter case of names leads outside;
    /// what was not found exactly is looked for ignoring case. A file whose identity is among
    /// `known` is found, but its text is not read again.
    ReadResult read(std::string_view path, std::string_view from_directory, std::uint64_t max_size,
                    const std::set<std::string>& known = {});

    /// Every file that was read, in order, each once, as paths that lead to it from here.
    std::span<const std::string> files_read() const { return files_read_; }

    /// From now on the content of what is read joins a fingerprint, but for the text of scenes.
    void begin_fingerprint() { has_fingerprint_ = true; }

    /// Of all files that were read since then, in order. Shape: begin_fingerprint() was called.
    const ContentHash& fingerprint() const { return fingerprint_; }

    /// Every place where a file was looked for in vain, in order, each once, as paths from here: a
    /// file that appears there would be read the next time. No more than kMaxFilesMissed; places
    /// outside of the allowed directories are not among them.
    std::span<const std::string> files_missed() const { return files_missed_; }

 private:
    struct Root {
        std::string directory{};  // as given
        std::string absolute{};   // the same, tidied as text
        std::string real{};       // the same without symbolic links
        Descriptor descriptor{};  // what decides
        bool is_searched = false;
    };
    struct Attempt {
        ReadStatus status = ReadStatus::outside;
        Descriptor file{};
        std::uint64_t size = 0;
        int error = 0;
        std::string allow{};
    };

    /// How much to read, and what not again.
    struct ReadLimits {
        std::uint64_t max_size = 0;
        const std::set<std::string>& known;
    };

    Attempt open(const std::string& shown) const;
    Attempt open_absolute(const std::string& absolute) const;
    Attempt open_below(const Root& root, const std::string& relative) const;
    void read_library(ReadResult& result, std::string_view name, const ReadLimits& limits);
    void read_ignoring_case(ReadResult& result, std::string_view written, const ReadLimits& limits);
    void finish(ReadResult& result, Attempt attempt, const ReadLimits& limits,
                const std::string& place);
    void note_missing(const std::string& place);

    BeneathMethod method_;
    std::vector<Root> roots_;
    Root library_;
    std::vector<std::string> files_read_;
    std::size_t searches_left_ = kMaxSearches;
    std::unordered_set<std::string> is_read_;
    std::vector<std::string> files_missed_;
    std::unordered_set<std::string> is_missed_;
    bool has_fingerprint_ = false;
    ContentHash fingerprint_{};
};

}  // namespace lray
