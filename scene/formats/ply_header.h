// The header of a PLY file: which elements follow, and the properties of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/source.h"
#include "scene/formats/ply_mistakes.h"

namespace lray::scene::ply {

enum class Coding : std::uint8_t { ascii, little_endian, big_endian };

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(Type type) {
    constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

constexpr bool is_whole(Type type) {
    return type < Type::float32;
}

/// A value of each row of an element; or a list of them, which its count comes before.
struct Property {
    std::string_view name{};
    Type type{};
    bool is_list = false;
    Type count_type{};
    std::string_view line{};  // of the header
};

/// So many rows of these properties.
struct Element {
    std::string_view name{};
    std::uint64_t count = 0;
    std::vector<Property> properties{};
    std::string_view line{};  // of the header

    /// The bytes that a row takes at least: lists may be empty, and of text values one digit and
    /// what ends it.
    std::size_t least_row_size(Coding coding) const;
};

/// Shape: all views are of the text.
struct Header {
    Coding coding{};
    std::vector<Element> elements{};  // each name once
    std::string_view end_line{};      // `end_header`
    const char* body = nullptr;       // where the rows begin
};

/// Returns the header of a file. `comment` and `obj_info` are skipped; lines end with LF, CR LF or,
/// where the first one does, CR.
/// Errors: empty when a mistake was told: words that are none, more elements or properties than the
/// limits, or more rows than the bytes that follow can hold.
std::optional<Header> read_header(const Text& text, Mistakes& mistakes);

}  // namespace lray::scene::ply
