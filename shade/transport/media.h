// Which transparent things a ray is inside of, one within the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lray::shade {

/// The materials of the media around a point, the innermost last. Of more than it can hold the
/// outermost are forgotten.
class Media {
 public:
    static constexpr std::size_t kMaxCount = 8;
    static constexpr std::uint32_t kNone = 0xffffffffu;  // empty space

    bool is_empty() const { return count_ == 0; }

    /// The medium that counts: that entered last.
    std::uint32_t innermost() const { return is_empty() ? kNone : materials_[count_ - 1]; }

    bool contains(std::uint32_t material) const {
        const auto end = materials_.begin() + static_cast<std::ptrdiff_t>(count_);
        return std::find(materials_.begin(), end, material) != end;
    }

    void enter(std::uint32_t material) {
        if (count_ == kMaxCount) {
            std::copy(materials_.begin() + 1, materials_.end(), materials_.begin());
            --count_;
        }
        materials_[count_++] = material;
    }

    /// Leaves the innermost medium of that material; nothing changes if there is none, as behind
    /// the back of a surface that closes nothing.
    void leave(std::uint32_t material) {
        for (std::size_t i = count_; i-- > 0;) {
            if (materials_[i] != material) continue;
            std::copy(materials_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                      materials_.begin() + static_cast<std::ptrdiff_t>(count_),
                      materials_.begin() + static_cast<std::ptrdiff_t>(i));
            --count_;
            return;
        }
    }

 private:
    std::array<std::uint32_t, kMaxCount> materials_{};
    std::size_t count_ = 0;
};

}  // namespace lray::shade
