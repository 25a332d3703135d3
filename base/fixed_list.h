// A list in place, of at most so many: nothing is set before it is added.
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>

#include "base/assert.h"

namespace lray {

/// Shape: `T` needs no destruction, so that to forget its members is enough.
template <class T, std::size_t kCapacity>
class FixedList {
    static_assert(std::is_trivially_destructible_v<T>);

 public:
    FixedList() {}  // NOLINT(modernize-use-equals-default): which would set the memory to zero
    FixedList(const FixedList&) = delete;
    FixedList& operator=(const FixedList&) = delete;

    /// Adds what make() returns, made where it stays. Errors: asserts that there is room.
    template <class Make>
    T& add_made(Make make) {
        LRAY_DCHECK(size_ < kCapacity);
        return *::new (static_cast<void*>(memory_ + sizeof(T) * size_++)) T(make());
    }
    T& add(const T& value) {
        return add_made([&] { return value; });
    }
    void remove_last() { --size_; }
    void clear() { size_ = 0; }

    std::size_t size() const { return size_; }
    bool is_empty() const { return size_ == 0; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    std::span<const T> all() const { return {data(), size_}; }

 private:
    T* data() { return std::launder(reinterpret_cast<T*>(memory_)); }
    const T* data() const { return std::launder(reinterpret_cast<const T*>(memory_)); }

    alignas(T) std::byte memory_[kCapacity * sizeof(T)];
    std::size_t size_ = 0;
};

}  // namespace lray
