#include "cli/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "base/sanitizers.h"
#include "cli/option_values.h"

namespace lray::cli {

const bool kCanLimitMemory = !kReservesTerabytes;

namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::uint64_t machine_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page_size = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_size <= 0) return kMost;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_size);
}

/// The number that a file consists of; the most if there is no such file, or it says "max".
std::uint64_t number_in(const std::string& path) {
    std::ifstream file(path);
    std::string text;
    file >> text;
    return parse_number(text).value_or(kMost);
}

/// The least limit of the control group the program runs in and of those around it.
std::uint64_t control_group_memory() {
    std::ifstream groups("/proc/self/cgroup");
    std::uint64_t least = kMost;
    for (std::string line; std::getline(groups, line);) {
        // Version 2 is "0::/path"; in version 1 the controllers stand between the colons.
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (second == line.npos) continue;
        const std::string_view controllers =
            std::string_view(line).substr(first + 1, second - first - 1);
        const bool is_second_version = controllers.empty();
        if (!is_second_version && controllers != "memory") continue;
        const std::string root = is_second_version ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
        const char* const name = is_second_version ? "/memory.max" : "/memory.limit_in_bytes";
        for (std::string path = line.substr(second + 1);; path.erase(path.rfind('/'))) {
            least = std::min(least, number_in(root + path + name));
            if (path.find('/') == path.npos) break;
        }
    }
    return least;
}

}  // namespace

std::uint64_t memory_limit(std::optional<std::uint64_t> wanted) {
    if (wanted) return *wanted;
    const std::uint64_t memory = std::min(machine_memory(), control_group_memory());
    return memory == kMost ? 0 : memory / 4 * 3;
}

void limit_memory(std::uint64_t bytes) {
    rlimit limit{};
    if (!kCanLimitMemory || bytes == 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    setrlimit(RLIMIT_DATA, &limit);  // where that is not possible, there is no limit
}

Failure out_of_memory() {
    return {ExitCode::limit, "there is not enough memory",
            "a smaller scene or a smaller `--size` needs less; `--max-memory N` lets it take more"};
}

}  // namespace lray::cli
