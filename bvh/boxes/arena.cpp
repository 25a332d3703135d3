#include "bvh/boxes/arena.h"

#include <sys/mman.h>
#include <unistd.h>

#include <new>
#include <utility>

#include "base/assert.h"

namespace lray::bvh {

namespace {

/// Below so many bytes the memory is the system's usual: a huge page would be wasted.
constexpr std::size_t kHugePageBytes = std::size_t{2} << 20;

std::size_t round_up_to_pages(std::size_t byte_count) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    return (byte_count + page - 1) / page * page;
}

}  // namespace

Arena::Arena(std::size_t byte_count) : size_(round_up_to_pages(byte_count)) {
    if (size_ == 0) return;
    void* const memory =
        mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<std::byte*>(memory);
    // Advice: where there are no huge pages, nothing is lost.
    if (size_ >= kHugePageBytes) madvise(data_, size_, MADV_HUGEPAGE);
}

Arena::~Arena() {
    if (data_ != nullptr) munmap(data_, size_);
}

Arena::Arena(Arena&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

Arena& Arena::operator=(Arena&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
}

void Arena::shrink(std::size_t byte_count) {
    const std::size_t kept = round_up_to_pages(byte_count);
    LRAY_ASSERT(kept <= size_);
    if (kept < size_) munmap(data_ + kept, size_ - kept);
    size_ = kept;
    if (size_ == 0) data_ = nullptr;
}

}  // namespace lray::bvh
