#include "base/file_access.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/nearby_files.h"
#include "base/path.h"
#include "base/read_all.h"

namespace lray {
namespace {

constexpr int kOpenFlags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;

ReadStatus status_of(int error) {
    switch (error) {
        case 0:
            return ReadStatus::ok;
        case ENOENT:
        case ENOTDIR:
            return ReadStatus::not_found;
        case EXDEV:
            return ReadStatus::outside;
        case ENXIO:
        case ENODEV:
            return ReadStatus::not_regular;
        default:
            return ReadStatus::unreadable;
    }
}

/// Returns the path without symbolic links; empty when there is no such file.
std::string real_path(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                           &std::free);
    return real ? std::string(real.get()) : std::string();
}

/// Returns the device and the number of a regular file on it; empty for others.
std::string identity_of(int file) {
    struct stat status {};
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
}

/// Returns `path` relative to `directory`, both absolute and tidy; empty if it is not below.
std::optional<std::string> relative_to(const std::string& path, const std::string& directory) {
    if (directory.empty()) return std::nullopt;
    if (path == directory) return ".";
    const std::string prefix = directory == "/" ? directory : directory + "/";
    if (!path.starts_with(prefix)) return std::nullopt;
    return path.substr(prefix.size());
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Takes the letter case of the end of `shown` from `found`, as far as they are the same name.
std::string with_case_of(std::string shown, std::string_view found) {
    for (std::size_t i = 1; i <= std::min(shown.size(), found.size()); ++i) {
        char& c = shown[shown.size() - i];
        if (lower(c) != lower(found[found.size() - i])) break;
        c = found[found.size() - i];
    }
    return shown;
}

/// Of what begins so, the rest is a path in the bundled library.
constexpr std::string_view kLibrary = "std:";

/// Returns the directory of a file that is not of the library: one may be called "std:" too.
std::string directory_beside(std::string_view path) {
    const std::string directory = directory_of(path);
    return directory.starts_with(kLibrary) ? "./" + directory : directory;
}

}  // namespace

void FileAccess::set_library(const std::string& directory) {
    library_.directory = directory;
    library_.absolute = absolute_path(directory);
    library_.real = real_path(directory);
    library_.descriptor = Descriptor(::open(directory.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
}

void FileAccess::allow(std::string directory, bool is_searched) {
    if (directory.empty()) directory += '.';
    Root root;
    root.absolute = absolute_path(directory);
    root.real = real_path(directory);
    root.descriptor = Descriptor(::open(directory.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    root.directory = std::move(directory);
    root.is_searched = is_searched;
    const auto known = std::find_if(roots_.begin(), roots_.end(), [&](const Root& other) {
        return other.directory == root.directory && other.absolute == root.absolute;
    });
    if (known == roots_.end()) {
        roots_.push_back(std::move(root));
        return;
    }
    root.is_searched = root.is_searched || known->is_searched;
    *known = std::move(root);  // opened again: the directory may be a new one of that name
}

ReadResult FileAccess::read_main(std::string_view path, std::uint64_t max_size) {
    ReadResult result;
    result.path = path;
    Attempt attempt;
    if (path == "-") {
        result.path = "<stdin>";
        attempt.file = Descriptor(fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0));
    } else {
        result.searched.push_back(result.path);
        // Without O_NONBLOCK: a FIFO waits for its writer.
        attempt.file = Descriptor(::open(result.path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
    }
    if (!attempt.file.is_open()) attempt.error = errno;
    attempt.status = status_of(attempt.error);
    if (attempt.status == ReadStatus::not_found) {
        note_missing(result.path);
        const std::string directory = directory_of(path);
        const std::string near = nearest_file_name(
            file_name_of(path),
            names_in(Descriptor(::open(directory.c_str(), kOpenFlags | O_DIRECTORY))));
        if (!near.empty()) result.nearest = join_paths(directory, near);
    }
    struct stat file {};
    if (attempt.file.is_open() && fstat(attempt.file.fd(), &file) == 0) {
        const bool is_regular = S_ISREG(file.st_mode);
        result.directory = is_regular && path != "-" ? directory_beside(path) : ".";
        if (is_regular) attempt.size = static_cast<std::uint64_t>(file.st_size);
        if (S_ISDIR(file.st_mode) || S_ISBLK(file.st_mode)) {
            attempt.status = ReadStatus::not_regular;
        } else {
            allow(result.directory, false);
        }
    }
    const std::set<std::string> none;
    finish(result, std::move(attempt), {max_size, none}, result.path);
    return result;
}

ReadResult FileAccess::read(std::string_view path, std::string_view from_directory,
                            std::uint64_t max_size, const std::set<std::string>& known) {
    const ReadLimits limits{std::min<std::uint64_t>(max_size, Sources::kMaxTextSize), known};
    ReadResult result;
    std::string written(path);
    result.used_backslash = written.find('\\') != std::string::npos;
    std::replace(written.begin(), written.end(), '\\', '/');
    result.is_absolute = written.starts_with('/');
    result.path = written;
    // A NUL would cut the name off where the system reads it.
    if (written.empty() || written.find('\0') != std::string::npos) return result;
    const bool is_from_library = from_directory.starts_with(kLibrary) && !result.is_absolute;
    if (written.starts_with(kLibrary)) {
        read_library(result, written.substr(kLibrary.size()), limits);
        return result;
    }
    if (is_from_library) {
        from_directory.remove_prefix(kLibrary.size());
        read_library(result, join_paths(from_directory, written), limits);
        return result;
    }

    result.searched.push_back(join_paths(from_directory, written));
    for (const Root& root : roots_) {
        if (root.is_searched && !result.is_absolute) {
            result.searched.push_back(join_paths(root.directory, written));
        }
    }
    std::optional<Attempt> first;
    for (const std::string& place : result.searched) {
        Attempt attempt = open(place);
        const bool is_here =
            attempt.status != ReadStatus::not_found && attempt.status != ReadStatus::outside;
        if (is_here) {
            result.path = place;
            finish(result, std::move(attempt), limits, place);
            return result;
        }
        if (attempt.status == ReadStatus::not_found) note_missing(place);
        if (!first) first = std::move(attempt);
    }
    result.path = result.searched.front();
    result.status = first->status;
    result.allow = first->allow;
    read_ignoring_case(result, written, limits);
    return result;
}

FileAccess::Attempt FileAccess::open(const std::string& shown) const {
    Attempt attempt = open_absolute(absolute_path(shown));
    if (attempt.status != ReadStatus::outside) return attempt;
    // By its text it is below an allowed directory, or it is not; by its links it may be below
    // another. Whatever is found out here, the decision is again made on the descriptor.
    const std::string real = real_path(shown);
    attempt.allow = directory_of(real.empty() ? shown : real);
    if (real.empty()) return attempt;
    Attempt by_links = open_absolute(real);
    return by_links.status == ReadStatus::outside ? std::move(attempt) : std::move(by_links);
}

FileAccess::Attempt FileAccess::open_absolute(const std::string& absolute) const {
    Attempt attempt;
    for (const Root& root : roots_) {
        std::optional<std::string> relative = relative_to(absolute, root.absolute);
        if (!relative) relative = relative_to(absolute, root.real);
        if (!relative) continue;
        if (!root.descriptor.is_open()) {
            attempt.status = ReadStatus::not_found;
            continue;
        }
        attempt = open_below(root, *relative);
        if (attempt.status != ReadStatus::outside) return attempt;
    }
    return attempt;
}

FileAccess::Attempt FileAccess::open_below(const Root& root, const std::string& relative) const {
    Attempt attempt;
    OpenedBeneath opened = open_beneath(root.descriptor.fd(), relative, kOpenFlags, method_);
    attempt.status = status_of(opened.error);
    attempt.error = opened.error;
    attempt.file = std::move(opened.file);
    struct stat file {};
    if (attempt.file.is_open() && fstat(attempt.file.fd(), &file) != 0) {
        attempt.status = ReadStatus::unreadable;
        attempt.error = errno;
    } else if (attempt.file.is_open() && !S_ISREG(file.st_mode)) {
        attempt.status = ReadStatus::not_regular;
    }
    attempt.size = static_cast<std::uint64_t>(file.st_size);
    return attempt;
}

void FileAccess::read_library(ReadResult& result, std::string_view name, const ReadLimits& limits) {
    const std::string tidy = join_paths(".", name);
    result.is_library = true;
    result.path = std::string(kLibrary) + tidy;
    result.searched.push_back(result.path);
    if (!library_.descriptor.is_open()) return;
    Attempt attempt = open_below(library_, tidy);
    // What leads out of the library is simply not in it.
    const bool is_there =
        attempt.status != ReadStatus::outside && attempt.status != ReadStatus::not_found;
    if (!is_there) {
        if (attempt.status == ReadStatus::not_found) {
            note_missing(join_paths(library_.directory, tidy));
        }
        constexpr int kListFlags = kOpenFlags | O_DIRECTORY;
        const int library = library_.descriptor.fd();
        result.available = names_in(open_beneath(library, ".", kListFlags, method_).file);
        const std::string near = nearest_file_name(tidy, result.available);
        if (!near.empty()) result.nearest = std::string(kLibrary) + near;
        return;
    }
    result.directory = directory_of(result.path);
    if (result.directory == ".") result.directory = kLibrary;
    finish(result, std::move(attempt), limits, join_paths(library_.directory, tidy));
}

void FileAccess::read_ignoring_case(ReadResult& result, std::string_view written,
                                    const ReadLimits& limits) {
    if (searches_left_ == 0) return;
    --searches_left_;
    const std::string_view name = file_name_of(written);
    for (const std::string& place : result.searched) {
        for (const Root& root : roots_) {
            const auto relative = relative_to(absolute_path(place), root.absolute);
            if (!relative || !root.descriptor.is_open()) continue;
            const Resemblance found = find_resemblance(root.descriptor.fd(), *relative, method_);
            if (result.nearest.empty() && !found.nearest.empty()) {
                result.nearest = written.substr(0, written.size() - name.size());
                result.nearest += found.nearest;
            }
            if (found.same_but_case.empty()) continue;
            std::string shown = with_case_of(place, found.same_but_case);
            Attempt attempt = open(shown);
            if (attempt.status != ReadStatus::ok) continue;
            result.path = std::move(shown);
            result.differs_in_case = true;
            result.allow.clear();
            result.nearest.clear();
            finish(result, std::move(attempt), limits, result.path);
            return;
        }
    }
}

void FileAccess::note_missing(const std::string& place) {
    const bool is_new = files_missed_.size() < kMaxFilesMissed && is_missed_.insert(place).second;
    if (is_new) files_missed_.push_back(place);
}

void FileAccess::finish(ReadResult& result, Attempt attempt, const ReadLimits& limits,
                        const std::string& place) {
    result.status = attempt.status;
    if (attempt.status == ReadStatus::unreadable) result.reason = error_words(attempt.error);
    if (attempt.status != ReadStatus::ok) return;
    if (result.directory.empty()) result.directory = directory_beside(result.path);
    result.identity = identity_of(attempt.file.fd());
    if (limits.known.contains(result.identity)) return;
    ReadAll read = read_all(attempt.file.fd(), attempt.size, limits.max_size);
    if (read.is_too_large) {
        result.status = ReadStatus::too_large;
    } else if (!read.text) {
        result.status = ReadStatus::unreadable;
        result.reason = error_words(read.error);
    } else {
        result.text = std::move(*read.text);
        if (has_fingerprint_ && !place.ends_with(".lrs")) {
            fingerprint_.add(result.text.view());
            fingerprint_.add(std::to_string(result.text.size()));  // where the next one begins
        }
        const bool is_named = !result.searched.empty();  // stdin has no name
        if (is_named && is_read_.insert(place).second) files_read_.push_back(place);
    }
}

}  // namespace lray
