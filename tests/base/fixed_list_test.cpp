#include "base/fixed_list.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace lray {
namespace {

/// Cannot be copied or moved: it has to be made in its place.
struct alignas(64) Pinned {
    explicit Pinned(int the_value) : value(the_value) {}
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;

    int value;
};

TEST(FixedList, BeginsEmptyAndHoldsWhatWasAddedInOrder) {
    FixedList<int, 4> list;
    EXPECT_TRUE(list.is_empty());
    for (const int value : {7, 8, 9}) EXPECT_EQ(list.add(value), value);
    EXPECT_EQ(list.size(), 3u);
    EXPECT_EQ(list[0], 7);
    EXPECT_EQ(list[2], 9);
    EXPECT_EQ(list.all().size(), 3u);
    EXPECT_EQ(list.all().back(), 9);
}

TEST(FixedList, WhatIsMadeIsMadeWhereItStays) {
    FixedList<Pinned, 3> list;
    for (int i = 0; i < 3; ++i) {
        const Pinned& made = list.add_made([i] { return Pinned(i); });
        EXPECT_EQ(&made, &list[static_cast<std::size_t>(i)]);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&made) % alignof(Pinned), 0u);
    }
    EXPECT_EQ(list[1].value, 1);
}

TEST(FixedList, HasRoomAgainForWhatWasRemoved) {
    FixedList<int, 2> list;
    list.add(1);
    list.add(2);
    list.remove_last();
    list.add(3);
    EXPECT_EQ(list[1], 3);
    list.clear();
    EXPECT_TRUE(list.is_empty());
    list.add(4);
    EXPECT_EQ(list[0], 4);
}

}  // namespace
}  // namespace lray
