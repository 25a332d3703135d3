// Typed indices: an id of one kind of thing cannot be used for another.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace lray {

/// Index into the array of `Tag`s. A default-made id refers to nothing.
template <class Tag>
struct Id {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t value = kNone;

    constexpr Id() = default;
    constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}

    constexpr bool is_none() const { return value == kNone; }
    constexpr std::size_t index() const { return value; }
    friend constexpr auto operator<=>(Id, Id) = default;
};

}  // namespace lray
