// A growing array of doubles for literal data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace lray::parser {

struct FreeMemory {
    void operator()(double* values) const { std::free(values); }
};
using OwnedNumbers = std::unique_ptr<double[], FreeMemory>;

/// Holds a few numbers in itself. Grows by realloc(), which moves the pages of large blocks
/// instead of copying them: a long list never stands in memory twice.
class PackedNumbers {
 public:
    void push(double value) {
        if (size_ == capacity_) grow();
        data_[size_++] = value;
    }
    std::size_t size() const { return size_; }
    const double* data() const { return data_; }

    /// Hands over the memory, trimmed; empty when the numbers are few and still inside.
    OwnedNumbers release() {
        if (owned_ == nullptr) return nullptr;
        void* trimmed = std::realloc(owned_.get(), size_ * sizeof(double));
        if (trimmed != nullptr) {
            static_cast<void>(owned_.release());
            owned_.reset(static_cast<double*>(trimmed));
        }
        return std::move(owned_);
    }

 private:
    void grow() {
        const std::size_t capacity = capacity_ * 2;
        void* grown = std::realloc(owned_.get(), capacity * sizeof(double));
        if (grown == nullptr) throw std::bad_alloc();
        if (owned_ == nullptr) std::memcpy(grown, inside_.data(), size_ * sizeof(double));
        static_cast<void>(owned_.release());
        owned_.reset(static_cast<double*>(grown));
        data_ = owned_.get();
        capacity_ = capacity;
    }

    std::array<double, 16> inside_;  // written before it is read
    OwnedNumbers owned_;
    double* data_ = inside_.data();
    std::size_t size_ = 0;
    std::size_t capacity_ = inside_.size();
};

}  // namespace lray::parser
