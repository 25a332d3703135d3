// The rows of an element in binary: stretches of a fixed size between lists.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "scene/formats/ply_header.h"

namespace lray::scene::ply {

/// Returns the value whose bytes stand at `at`; `is_swapped` if not in the order of this machine.
template <class T, bool is_swapped>
T load_value(const char* at) {
    static_assert(std::endian::native == std::endian::little);
    char bytes[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = at[is_swapped ? sizeof(T) - 1 - i : i];
    T value{};
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// Calls a function with a value of the C++ type.
template <class Function>
auto with_type(Type type, Function&& function) {
    switch (type) {
        case Type::int8:
            return function(std::int8_t{});
        case Type::uint8:
            return function(std::uint8_t{});
        case Type::int16:
            return function(std::int16_t{});
        case Type::uint16:
            return function(std::uint16_t{});
        case Type::int32:
            return function(std::int32_t{});
        case Type::uint32:
            return function(std::uint32_t{});
        case Type::float32:
            return function(float{});
        case Type::float64:
            break;
    }
    return function(double{});
}

/// Returns a value of a whole type.
inline std::int64_t load_whole(Type type, bool is_swapped, const char* at) {
    return with_type(type, [&](auto zero) {
        using T = decltype(zero);
        return static_cast<std::int64_t>(is_swapped ? load_value<T, true>(at)
                                                    : load_value<T, false>(at));
    });
}

/// A stretch of fixed size, and the list behind it.
struct RowStep {
    std::size_t fixed_size = 0;
    bool has_list = false;  // false of the last alone
    Type count_type{};
    Type item_type{};
    std::size_t property = 0;  // the list
};

struct RowPlan {
    std::vector<RowStep> steps{};        // one or more
    std::vector<std::size_t> offsets{};  // by property: where it is in the row without its lists
    std::size_t packed_size = 0;         // of that row

    bool has_lists() const { return steps.size() > 1; }
};

RowPlan plan_row(const Element& element);

}  // namespace lray::scene::ply
