// A bump allocator for what lives as long as one load: syntax trees and values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#endif

namespace lray::parser {

/// Memory that is freed all at once. Holds only what needs no destructor. AddressSanitizer sees
/// what is read after it was given back.
class Arena {
 public:
    Arena() = default;
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;

    template <class T, class... Args>
    T* make(Args&&... args) {
        static_assert(std::is_trivially_destructible_v<T>);
        return ::new (allocate(sizeof(T), alignof(T))) T{std::forward<Args>(args)...};
    }

    template <class T>
    std::span<T> copy(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (values.empty()) return {};
        T* begin = static_cast<T*>(allocate(values.size_bytes(), alignof(T)));
        std::uninitialized_copy(values.begin(), values.end(), begin);
        return {begin, values.size()};
    }

    template <class T>
    std::span<T> copy(const std::vector<T>& values) {
        return copy(std::span<const T>(values));
    }

    std::string_view copy(std::string_view text) {
        const std::span<char> bytes = copy(std::span<const char>(text.data(), text.size()));
        return {bytes.data(), bytes.size()};
    }

    /// How far the arena is filled.
    struct Mark {
        std::size_t block_count = 0;
        std::byte* next = nullptr;

        friend bool operator==(const Mark&, const Mark&) = default;
    };

    Mark mark() const { return {used_blocks_, next_}; }

    /// Gives back all that was allocated since the mark was taken; its memory is used again.
    void reset(const Mark& mark) {
        poison_since(mark);
        next_ = mark.next;
        if (used_blocks_ == mark.block_count) return;
        used_blocks_ = mark.block_count;
        end_ = used_blocks_ == 0 ? nullptr : blocks_[used_blocks_ - 1].end();
    }

    /// True if `at` was allocated since the mark was taken.
    bool holds(const void* at, const Mark& mark) const {
        const auto* const byte = static_cast<const std::byte*>(at);
        const std::less<> is_before;
        for (std::size_t i = used_blocks_; i-- > mark.block_count;) {
            const Block& block = blocks_[i];
            const bool is_inside =
                !is_before(byte, block.bytes.get()) && is_before(byte, block.end());
            if (is_inside) return true;
        }
        if (mark.block_count == 0) return false;
        return !is_before(byte, mark.next) && is_before(byte, blocks_[mark.block_count - 1].end());
    }

    /// Bytes allocated since the mark was taken, or a few more: of a block that was left, what was
    /// too small at its end counts.
    std::size_t size_since(const Mark& mark) const {
        if (used_blocks_ == mark.block_count) {
            return static_cast<std::size_t>(next_ - mark.next);
        }
        const std::byte* const begin = blocks_[used_blocks_ - 1].bytes.get();
        auto size = static_cast<std::size_t>(next_ - begin);
        for (std::size_t i = mark.block_count; i + 1 < used_blocks_; ++i) size += blocks_[i].size;
        if (mark.block_count > 0) {
            size += static_cast<std::size_t>(blocks_[mark.block_count - 1].end() - mark.next);
        }
        return size;
    }

    /// Bytes taken from the system.
    std::size_t size() const { return size_; }

    void* allocate(std::size_t size, std::size_t alignment) {
        auto begin = reinterpret_cast<std::uintptr_t>(next_);
        begin = (begin + alignment - 1) & ~(std::uintptr_t{alignment} - 1);
        // Nothing, too, has a place: null would be taken for a failure.
        if (next_ == nullptr || begin + size > reinterpret_cast<std::uintptr_t>(end_)) {
            add_block(size + alignment);
            begin = reinterpret_cast<std::uintptr_t>(next_);
            begin = (begin + alignment - 1) & ~(std::uintptr_t{alignment} - 1);
        }
        next_ = reinterpret_cast<std::byte*>(begin + size);
#if defined(__SANITIZE_ADDRESS__)
        ASAN_UNPOISON_MEMORY_REGION(reinterpret_cast<void*>(begin), size);
#endif
        return reinterpret_cast<void*>(begin);
    }

 private:
    static constexpr std::size_t kFirstBlock = std::size_t{16} << 10;
    static constexpr std::size_t kLargestBlock = std::size_t{16} << 20;

    struct Block {
        std::unique_ptr<std::byte[]> bytes{};
        std::size_t size = 0;

        std::byte* end() const { return bytes.get() + size; }
    };

    void add_block(std::size_t least) {
        if (used_blocks_ < blocks_.size() && blocks_[used_blocks_].size < least) free_unused();
        if (used_blocks_ == blocks_.size()) {
            const std::size_t size = std::max(least, block_size_);
            block_size_ = std::min(block_size_ * 2, kLargestBlock);
            blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(size), size});
            size_ += size;
        }
        next_ = blocks_[used_blocks_].bytes.get();
        end_ = blocks_[used_blocks_].end();
        ++used_blocks_;
    }

    void poison_since([[maybe_unused]] const Mark& mark) {
#if defined(__SANITIZE_ADDRESS__)
        if (used_blocks_ == mark.block_count) {
            ASAN_POISON_MEMORY_REGION(mark.next, static_cast<std::size_t>(next_ - mark.next));
            return;
        }
        if (mark.block_count > 0) {
            const std::byte* const end = blocks_[mark.block_count - 1].end();
            ASAN_POISON_MEMORY_REGION(mark.next, static_cast<std::size_t>(end - mark.next));
        }
        for (std::size_t i = mark.block_count; i < used_blocks_; ++i) {
            ASAN_POISON_MEMORY_REGION(blocks_[i].bytes.get(), blocks_[i].size);
        }
#endif
    }

    void free_unused() {
        while (blocks_.size() > used_blocks_) {
            size_ -= blocks_.back().size;
            blocks_.pop_back();
        }
    }

    std::vector<Block> blocks_;
    std::size_t used_blocks_ = 0;  // those behind are kept for later
    std::byte* next_ = nullptr;
    std::byte* end_ = nullptr;
    std::size_t block_size_ = kFirstBlock;
    std::size_t size_ = 0;
};

}  // namespace lray::parser
