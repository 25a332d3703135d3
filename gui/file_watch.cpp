#include "gui/file_watch.h"

#include <fmt/format.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/path.h"
#include "base/terminal_text.h"

namespace lray::gui {

namespace {

constexpr std::uint32_t kWritten = IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE;
constexpr std::uint32_t kDirectoryGone = IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT | IN_IGNORED;
constexpr std::uint32_t kWatched = kWritten | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

/// True for a file that has just been made and is still being filled: its end is told, too.
bool is_being_written(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0;
}

/// Returns what a symbolic link says; empty for all else.
std::string link_target(const std::string& path) {
    std::array<char, 4096> buffer{};
    const ssize_t length = ::readlink(path.c_str(), buffer.data(), buffer.size());
    return length > 0 ? std::string(buffer.data(), static_cast<std::size_t>(length))
                      : std::string();
}

}  // namespace

FileWatch::FileWatch(WatchMethod method) : method_(method) {
    start();
}

void FileWatch::start() {
    if (method_ == WatchMethod::comparing) return cannot_watch("not used");
    if (!notifier_.is_open()) notifier_ = Descriptor(inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    if (!notifier_.is_open()) cannot_watch(error_words(errno));
}

void FileWatch::cannot_watch(const std::string& why) {
    if (!problem_.empty()) return;
    problem_ = "the system does not tell when files are saved (" + why +
               "); they are looked at twice a second";
}

void FileWatch::watch(std::span<const std::string> paths) {
    paths_.assign(paths.begin(), paths.end());
    std::unordered_map<std::string, Signature> old = std::exchange(signatures_, {});
    for (const std::string& path : paths_) {
        const auto known = old.find(path);
        signatures_.emplace(path, known == old.end() ? signature_of(path) : known->second);
    }
    watch_again();
}

// What is still watched stays so, with the events that wait to be read.
void FileWatch::watch_again() {
    std::map<int, std::set<std::string>> old = std::exchange(names_, {});
    directories_.clear();
    problem_.clear();
    is_stale_ = false;
    start();
    for (const std::string& path : paths_) watch_place(path);
    for (const auto& [watch, names] : old) {
        if (!names_.contains(watch)) inotify_rm_watch(notifier_.fd(), watch);
    }
    compare();  // what happened before it was watched
}

// Watches for a path where it stands and where links at its end lead; without a directory to watch,
// for that directory to appear.
void FileWatch::watch_place(std::string path) {
    constexpr int kMaxLinks = 40;  // as Linux has it
    int links_left = kMaxLinks;
    while (links_left > 0) {
        const std::string directory = directory_of(path);
        if (!watch_directory(directory, std::string(file_name_of(path)))) {
            if (directory == path || directory == "." || directory == "/") return;
            path = directory;
            continue;
        }
        const std::string target = link_target(path);
        if (target.empty()) return;
        // Put together as text, unchanged: "x/.." may not be tidied away where x is a link.
        path = target.starts_with('/') ? target : directory + "/" + target;
        --links_left;
    }
}

// Returns false if there is no such directory.
bool FileWatch::watch_directory(const std::string& directory, const std::string& name) {
    auto known = directories_.find(directory);
    if (known == directories_.end()) {
        struct stat status {};
        if (::stat(directory.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) return false;
        Directory made{-1, status.st_dev, status.st_ino};
        if (names_.size() >= kMaxWatches) {
            cannot_watch(fmt::format("more than {} directories", kMaxWatches));
        } else if (notifier_.is_open()) {
            made.watch = inotify_add_watch(notifier_.fd(), directory.c_str(), kWatched);
            if (made.watch < 0) {
                const int error = errno;
                if (error == ENOENT || error == ENOTDIR) return false;
                cannot_watch(error == ENOSPC
                                 ? "no more directories can be watched"
                                 : fmt::format("directory `{}`: {}", escape_for_terminal(directory),
                                               error_words(error)));
            }
        }
        known = directories_.emplace(directory, made).first;
    }
    if (known->second.watch >= 0) names_[known->second.watch].insert(name);
    return true;
}

bool FileWatch::poll(double now) {
    read_events();
    if (now - last_look_ >= kPollPeriod) {
        last_look_ = now;
        if (!problem_.empty()) compare();
        if (!is_stale_) is_stale_ = has_moved_directory();
    }
    // All paths are gone through: not more often than that.
    if (is_stale_ && now - last_watched_again_ >= kQuiet) {
        last_watched_again_ = now;
        watch_again();
    }
    if (std::exchange(is_changed_, false)) {
        if (!is_pending_) first_change_ = now;
        is_pending_ = true;
        last_change_ = now;
    }
    const bool is_over = now - last_change_ >= kQuiet || now - first_change_ >= kLongest;
    if (!is_pending_ || is_stale_ || !is_over) return false;
    is_pending_ = false;
    remember();
    return true;
}

void FileWatch::read_events() {
    constexpr int kMaxReads = 64;  // more are left to the next time
    alignas(inotify_event) std::array<char, std::size_t{1} << 14> buffer;
    for (int i = 0; i < kMaxReads && notifier_.is_open(); ++i) {
        const ssize_t length = ::read(notifier_.fd(), buffer.data(), buffer.size());
        if (length <= 0) return;
        for (std::size_t at = 0; at < static_cast<std::size_t>(length);) {
            inotify_event event{};
            std::memcpy(&event, buffer.data() + at, sizeof(event));
            const char* const name = buffer.data() + at + sizeof(event);
            note_event(event.wd, event.mask,
                       event.len > 0 ? std::string(name, ::strnlen(name, event.len)) : "");
            at += sizeof(event) + event.len;
        }
    }
}

void FileWatch::note_event(int watch, std::uint32_t what, const std::string& name) {
    if ((what & IN_Q_OVERFLOW) != 0) {  // events were lost
        is_changed_ = true;
        is_stale_ = true;
        return;
    }
    const auto names = names_.find(watch);
    if (names == names_.end()) return;  // of a directory that is not watched any more
    if ((what & kDirectoryGone) != 0) is_stale_ = true;
    if ((what & kWritten) == 0 || !names->second.contains(name)) return;
    // It may be a directory that was missing, or a link that leads elsewhere now.
    if ((what & (IN_MOVED_TO | IN_CREATE)) != 0) is_stale_ = true;
    if ((what & IN_ISDIR) != 0) return;
    if ((what & IN_CREATE) != 0) {
        const auto directory =
            std::ranges::find(directories_, watch, [](const auto& d) { return d.second.watch; });
        if (is_being_written(directory->first + "/" + name)) return;
    }
    is_changed_ = true;
}

bool FileWatch::has_moved(const std::string& path, const Directory& directory) const {
    struct stat status {};
    return ::stat(path.c_str(), &status) != 0 || status.st_dev != directory.device ||
           status.st_ino != directory.number;
}

// A directory further up was moved, or a link to a directory was changed: the system does not tell.
bool FileWatch::has_moved_directory() const {
    return std::ranges::any_of(
        directories_, [&](const auto& known) { return has_moved(known.first, known.second); });
}

FileWatch::Signature FileWatch::signature_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {true,           status.st_dev,         status.st_ino,
            status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

void FileWatch::compare() {
    for (auto& [path, before] : signatures_) {
        const Signature now = signature_of(path);
        if (!now.exists || now == before) continue;
        if (now.size == 0 && problem_.empty()) continue;  // when it is filled, that is told
        before = now;
        is_changed_ = true;
    }
}

void FileWatch::remember() {
    for (auto& [path, signature] : signatures_) {
        const Signature now = signature_of(path);
        if (now.exists) signature = now;
    }
}

}  // namespace lray::gui
