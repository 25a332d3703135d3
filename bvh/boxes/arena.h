// One stretch of memory for a tree, on huge pages where the system has them.
#pragma once

#include <cstddef>

namespace lray::bvh {

/// Memory that is mapped on its own and freed as one. Its pages are the system's until written to.
class Arena {
 public:
    Arena() = default;
    /// Errors: throws std::bad_alloc when the system gives no more, as `new` does.
    explicit Arena(std::size_t byte_count);
    ~Arena();
    Arena(Arena&& other) noexcept;
    Arena& operator=(Arena&& other) noexcept;

    std::byte* data() const { return data_; }
    std::size_t size() const { return size_; }

    /// Gives what lies behind the first `byte_count` bytes back to the system.
    void shrink(std::size_t byte_count);

 private:
    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace lray::bvh
