// Notices that files were saved: told by the system, or by looking at them now and then.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/descriptor.h"

namespace lray::gui {

/// `notified`: inotify. `comparing`: without it, as where the system does not have it.
enum class WatchMethod : std::uint8_t { notified, comparing };

/// Watches the directories that files are in and not the files: editors write a new one and rename
/// it. Neither blocks nor has a thread; time is what the caller says.
class FileWatch {
 public:
    /// Seconds without a change before a change is reported: a save is several events.
    static constexpr double kQuiet = 0.05;
    /// Seconds after which it is reported even if changes do not end.
    static constexpr double kLongest = 0.5;
    /// Seconds between looks at what the system does not tell.
    static constexpr double kPollPeriod = 0.5;
    /// A scene may name files in any number of directories; so many are watched.
    static constexpr std::size_t kMaxWatches = 1000;

    explicit FileWatch(WatchMethod method = WatchMethod::notified);

    /// Watches these paths from now on, and no others. Files may be missing, with their directories
    /// too: that they appear is a change. What happened to files that were watched before and still
    /// are is not forgotten, so that nothing is lost while the files are being read again.
    void watch(std::span<const std::string> paths);

    /// Returns true once after a file was written, replaced, or made; not after one was removed,
    /// which editors do on their way to a new one.
    /// Units: seconds from any begin, never less than before.
    bool poll(double now);

    /// Why files have to be looked at every kPollPeriod, in a sentence; empty if they need not be.
    const std::string& problem() const { return problem_; }

    /// Directories that the system watches.
    std::size_t watch_count() const { return names_.size(); }

 private:
    /// Which file a path leads to, and in which state.
    struct Signature {
        bool exists = false;
        dev_t device = 0;
        ino_t number = 0;
        off_t size = 0;
        std::int64_t seconds = 0;
        std::int64_t nanoseconds = 0;

        friend bool operator==(const Signature&, const Signature&) = default;
    };
    struct Directory {
        int watch = -1;  // none where the system does not watch it
        dev_t device = 0;
        ino_t number = 0;
    };

    static Signature signature_of(const std::string& path);
    void start();
    void watch_again();
    void watch_place(std::string path);
    bool watch_directory(const std::string& directory, const std::string& name);
    void read_events();
    void note_event(int watch, std::uint32_t what, const std::string& name);
    bool has_moved(const std::string& path, const Directory& directory) const;
    bool has_moved_directory() const;
    void compare();
    void remember();
    void cannot_watch(const std::string& why);

    WatchMethod method_;
    Descriptor notifier_;
    std::vector<std::string> paths_;
    std::unordered_map<std::string, Signature> signatures_;  // by path, when last reported
    std::map<std::string, Directory> directories_;           // by path
    std::map<int, std::set<std::string>> names_;             // what counts, by watch
    std::string problem_;

    static constexpr double kNever = -std::numeric_limits<double>::infinity();
    bool is_changed_ = false;  // since the last poll
    bool is_pending_ = false;  // changed, and not reported yet
    bool is_stale_ = false;    // a directory or link is another one now
    double first_change_ = kNever;
    double last_change_ = kNever;
    double last_look_ = kNever;
    double last_watched_again_ = kNever;
};

}  // namespace lray::gui
