#include "scene/formats/ply_binary.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace lray::scene::ply {

namespace {

template <bool is_swapped>
void fill_column(Type type, const char* at, std::size_t row_size, std::span<float> column) {
    with_type(type, [&](auto zero) {
        using T = decltype(zero);
        for (float& value : column) {
            value = static_cast<float>(load_value<T, is_swapped>(at));
            at += row_size;
        }
    });
}

}  // namespace

void BinaryRows::begin_element(std::size_t element) {
    element_ = element;
    plan_ = plan_row(header_.elements[element]);
    row_ = 0;
}

const char* BinaryRows::skip(std::size_t element_index, const char* at) {
    begin_element(element_index);
    if (!plan_.has_lists()) {
        if (plan_.packed_size == 0) return at;
        const std::uint64_t fitting = left(at) / plan_.packed_size;
        if (element().count > fitting) {
            row_ = fitting;
            return ends_early(at + fitting * plan_.packed_size);
        }
        return at + element().count * plan_.packed_size;
    }
    for (; at != nullptr && row_ < element().count; ++row_) at = skip_row(at, nullptr);
    return at;
}

/// Returns the end of a row; its values without the lists are copied to `packed`, if there is one.
const char* BinaryRows::skip_row(const char* at, char* packed) {
    for (const RowStep& step : plan_.steps) {
        if (left(at) < step.fixed_size) return ends_early(at);
        if (packed != nullptr) packed = std::copy_n(at, step.fixed_size, packed);
        at += step.fixed_size;
        if (!step.has_list) break;
        at = find_list(step, at).end;
        if (at == nullptr) return nullptr;
    }
    return at;
}

BinaryRows::List BinaryRows::find_list(const RowStep& step, const char* at) {
    const std::size_t count_size = size_of(step.count_type);
    if (left(at) < count_size) {
        ends_early(at);
        return {};
    }
    const std::int64_t count = load_whole(step.count_type, is_swapped_, at);
    const char* const begin = at + count_size;
    if (count < 0) {
        mistakes_.in_bytes(Code::E0701,
                           fmt::format("{} {}, at byte {}, has a list of {} values",
                                       quoted(element().name), row_, mistakes_.byte_at(at), count));
        return {};
    }
    const auto size = static_cast<std::uint64_t>(count) * size_of(step.item_type);
    if (left(begin) < size) {
        mistakes_.in_bytes(
            Code::E0701,
            fmt::format("{} {}, at byte {}, has a list of {} bytes, but the file ends after {}",
                        quoted(element().name), row_, mistakes_.byte_at(at), size, left(begin)));
        return {};
    }
    return {begin, static_cast<std::size_t>(count), begin + size};
}

const char* BinaryRows::read_vertices(const char* at) {
    begin_element(layout_.vertex_element);
    builder_.reserve_vertices(element().count);
    std::vector<char> packed;
    if (plan_.has_lists()) packed.resize(VertexBlock::kCapacity * plan_.packed_size);
    VertexBlock block;
    while (row_ < element().count) {
        block.count = std::min<std::uint64_t>(VertexBlock::kCapacity, element().count - row_);
        const std::uint64_t first_row = row_;
        const char* const begin = at;
        if (plan_.has_lists()) {
            for (std::size_t i = 0; i < block.count; ++i, ++row_) {
                at = skip_row(at, packed.data() + i * plan_.packed_size);
                if (at == nullptr) return nullptr;
            }
            fill(block, packed.data(), plan_.packed_size);
        } else {
            if (left(at) / plan_.packed_size < block.count) return skip(element_, begin);
            fill(block, at, plan_.packed_size);
            at += block.count * plan_.packed_size;
            row_ += block.count;
        }
        const std::size_t added = builder_.add_vertices(block);
        if (added < block.count) {
            return wrong_vertex(plan_.has_lists() ? nullptr : begin + added * plan_.packed_size,
                                first_row + added);
        }
    }
    return at;
}

void BinaryRows::fill(VertexBlock& block, const char* rows, std::size_t row_size) const {
    for (std::size_t slot = 0; slot < kSlotCount; ++slot) {
        const std::size_t property = layout_.properties[slot];
        if (property == Layout::kNone) continue;
        const auto column = std::span(block.values[slot]).first(block.count);
        const char* const first = rows + plan_.offsets[property];
        const Type type = element().properties[property].type;
        if (is_swapped_) {
            fill_column<true>(type, first, row_size, column);
        } else {
            fill_column<false>(type, first, row_size, column);
        }
    }
}

const char* BinaryRows::read_indices(const IndexLists& lists, const char* at) {
    begin_element(lists.element);
    const RowStep& step = plan_.steps[0];
    const bool is_common = !lists.are_strips && plan_.steps.size() == 2 &&
                           size_of(step.item_type) == sizeof(std::uint32_t);
    builder_.reserve_triangles(count_triangles(at));
    while (at != nullptr && row_ < element().count) {
        if (is_common && step.count_type == Type::uint8) {
            at = is_swapped_ ? read_triangles<std::uint8_t, true>(at)
                             : read_triangles<std::uint8_t, false>(at);
        } else if (is_common && size_of(step.count_type) == sizeof(std::uint32_t)) {
            at = is_swapped_ ? read_triangles<std::uint32_t, true>(at)
                             : read_triangles<std::uint32_t, false>(at);
        }
        if (row_ == element().count) break;
        at = read_index_row(lists, at);
        ++row_;
    }
    return at;
}

/// Reads rows with one list, of three vertices that exist, up to the first that is otherwise.
/// Numbers below 0 are too large without their sign.
template <class Count, bool is_swapped>
const char* BinaryRows::read_triangles(const char* at) {
    const std::size_t before = plan_.steps[0].fixed_size;
    const std::size_t row_size =
        before + sizeof(Count) + 3 * sizeof(std::uint32_t) + plan_.steps[1].fixed_size;
    const auto vertex_count = static_cast<std::uint32_t>(builder_.vertex_count());
    constexpr std::uint64_t kBlock = 1024;  // so that what is cleared is still at hand when written
    for (;;) {
        const std::uint64_t row_count =
            std::min({element().count - row_, left(at) / row_size, kBlock});
        const std::span<IndexTriple> room = builder_.add_room(row_count);
        std::size_t i = 0;
        for (; i < row_count; ++i, at += row_size) {
            const char* const list = at + before;
            if (load_value<Count, is_swapped>(list) != 3) break;
            const char* const corners = list + sizeof(Count);
            const IndexTriple triangle = {load_value<std::uint32_t, is_swapped>(corners),
                                          load_value<std::uint32_t, is_swapped>(corners + 4),
                                          load_value<std::uint32_t, is_swapped>(corners + 8)};
            if (std::max({triangle[0], triangle[1], triangle[2]}) >= vertex_count) break;
            room[i] = triangle;
        }
        row_ += i;
        builder_.take_back(row_count - i);
        if (i < kBlock) return at;
    }
}

/// Returns how many triangles the rows from `at` on make: exactly if they have no
/// other lists and what follows has none, else more or less; never more than the bytes hold.
std::size_t BinaryRows::count_triangles(const char* at) const {
    std::uint64_t item_bytes = left(at);
    for (std::size_t i = element_ + 1; i < header_.elements.size(); ++i) {
        const Element& other = header_.elements[i];
        item_bytes -= std::min(item_bytes, other.count * other.least_row_size(header_.coding));
    }
    std::size_t item_size = 1;
    for (const RowStep& step : plan_.steps) {
        std::uint64_t row_bytes = step.fixed_size;
        if (step.has_list) {
            row_bytes += size_of(step.count_type);
            item_size = size_of(step.item_type);
        }
        item_bytes -= std::min(item_bytes, row_bytes * element().count);
    }
    const std::uint64_t corners = item_bytes / item_size;
    return corners - std::min(corners, 2 * element().count);
}

const char* BinaryRows::read_index_row(const IndexLists& lists, const char* at) {
    const char* const row = at;
    for (const RowStep& step : plan_.steps) {
        if (left(at) < step.fixed_size) return ends_early(at);
        at += step.fixed_size;
        if (!step.has_list) break;
        const List list = find_list(step, at);
        if (list.end == nullptr) return nullptr;
        at = list.end;
        if (step.property != lists.property) continue;
        if (!lists.are_strips && list.count < 3) {
            mistakes_.in_bytes(Code::E0701,
                               fmt::format("face {}, at byte {}, has {} corners: it needs at least "
                                           "3",
                                           row_, mistakes_.byte_at(row), list.count));
            return nullptr;
        }
        if (!lists.are_strips && list.count > kMaxCorners) {
            mistakes_.in_bytes(Code::E0705,
                               fmt::format("face {}, at byte {}, has {} corners; it can have {}",
                                           row_, mistakes_.byte_at(row), list.count, kMaxCorners));
            return nullptr;
        }
        if (!add_list(lists.are_strips, step.item_type, list)) return nullptr;
    }
    return at;
}

/// Adds what a list of vertices makes: a polygon, or strips.
bool BinaryRows::add_list(bool are_strips, Type type, const List& list) {
    const auto vertex_count = static_cast<std::int64_t>(builder_.vertex_count());
    const std::size_t item_size = size_of(type);
    corners_.clear();
    builder_.end_strip();
    const char* at = list.begin;
    for (std::size_t i = 0; i < list.count; ++i, at += item_size) {
        const std::int64_t index = load_whole(type, is_swapped_, at);
        if (are_strips && index == -1) {
            builder_.end_strip();
        } else if (index < 0 || index >= vertex_count) {
            mistakes_.in_bytes(
                Code::E0702, fmt::format("{} {}, at byte {}, names vertex {} of {}",
                                         are_strips ? "strip" : "face", row_, mistakes_.byte_at(at),
                                         index, vertex_count));
            return false;
        } else if (are_strips) {
            builder_.continue_strip(static_cast<std::uint32_t>(index));
        } else {
            corners_.push_back(static_cast<std::uint32_t>(index));
        }
    }
    if (!are_strips) builder_.add_face(corners_);
    return true;
}

const char* BinaryRows::ends_early(const char* at) {
    mistakes_.in_bytes(Code::E0701, fmt::format("the file ends at byte {}, in {} {} of {}",
                                                mistakes_.byte_at(at) + left(at),
                                                quoted(element().name), row_, element().count));
    return nullptr;
}

const char* BinaryRows::wrong_vertex(const char* at, std::size_t number) {
    const std::string where =
        at == nullptr ? std::string() : fmt::format(", at byte {},", mistakes_.byte_at(at));
    mistakes_.in_bytes(Code::E0701,
                       fmt::format("vertex {}{} has a number that is not finite", number, where));
    return nullptr;
}

}  // namespace lray::scene::ply
