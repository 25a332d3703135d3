#include "base/open_beneath.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <utility>
#include <vector>

#include "base/path.h"

#if __has_include(<linux/openat2.h>)
#include <linux/openat2.h>
#include <sys/syscall.h>
#endif

namespace lray {
namespace {

OpenedBeneath failed(int error) {
    return {Descriptor{}, error};
}

OpenedBeneath opened(int fd) {
    return fd >= 0 ? OpenedBeneath{Descriptor(fd), 0} : failed(errno);
}

#ifdef SYS_openat2
OpenedBeneath open_by_kernel(int root, const char* path, int flags) {
    open_how how{};
    how.flags = static_cast<std::uint64_t>(flags);
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
    // EAGAIN: something was renamed meanwhile, and ".." could not be judged.
    constexpr int kMaxTries = 16;
    OpenedBeneath result;
    for (int i = 0; i < kMaxTries; ++i) {
        result = opened(static_cast<int>(syscall(SYS_openat2, root, path, &how, sizeof how)));
        if (result.error != EAGAIN && result.error != EINTR) break;
    }
    return result;
}
#else
OpenedBeneath open_by_kernel(int, const char*, int) {
    return failed(ENOSYS);
}
#endif

/// Puts the names of a path on a stack, the first on top.
void push_components(std::vector<std::string>& stack, std::string_view path) {
    const std::vector<std::string_view> names = path_components(path);
    for (auto name = names.rbegin(); name != names.rend(); ++name) stack.emplace_back(*name);
}

OpenedBeneath open_by_walking(int root, const std::string& path, int flags) {
    constexpr int kMaxLinks = 40;  // as Linux has it
    if (path.starts_with('/')) return failed(EXDEV);
    // The directories walked into are held open: ".." steps back to the one held, never to what
    // has become its parent meanwhile.
    std::vector<Descriptor> directories;
    std::vector<std::string> left;
    push_components(left, path);
    int link_count = 0;
    while (!left.empty()) {
        const std::string name = std::move(left.back());
        left.pop_back();
        if (name == "..") {
            if (directories.empty()) return failed(EXDEV);
            directories.pop_back();
            continue;
        }
        const int here = directories.empty() ? root : directories.back().fd();
        Descriptor entry(openat(here, name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
        if (!entry.is_open()) return failed(errno);
        struct stat status {};
        if (fstat(entry.fd(), &status) != 0) return failed(errno);
        if (S_ISLNK(status.st_mode)) {
            if (++link_count > kMaxLinks) return failed(ELOOP);
            std::array<char, 4096> target{};
            const ssize_t length = readlinkat(entry.fd(), "", target.data(), target.size());
            if (length < 0) return failed(errno);
            if (length > 0 && target[0] == '/') return failed(EXDEV);
            push_components(left, {target.data(), static_cast<std::size_t>(length)});
            continue;
        }
        if (left.empty()) return opened(openat(here, name.c_str(), flags | O_NOFOLLOW));
        directories.push_back(std::move(entry));
    }
    return opened(openat(directories.empty() ? root : directories.back().fd(), ".", flags));
}

}  // namespace

BeneathMethod best_beneath_method() {
    static const bool has_kernel = open_by_kernel(AT_FDCWD, ".", O_PATH | O_CLOEXEC).error == 0;
    return has_kernel ? BeneathMethod::kernel : BeneathMethod::walk;
}

OpenedBeneath open_beneath(int root, const std::string& path, int flags, BeneathMethod method) {
    switch (method) {
        case BeneathMethod::kernel:
            return open_by_kernel(root, path.c_str(), flags);
        case BeneathMethod::walk:
            return open_by_walking(root, path, flags);
    }
    return failed(EINVAL);
}

}  // namespace lray
