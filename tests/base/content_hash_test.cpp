#include "base/content_hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/random.h"

namespace lray {
namespace {

std::string hash_of(std::string_view text) {
    ContentHash hash;
    hash.add(text);
    return hash.text();
}

TEST(ContentHash, HowBytesAreCutDoesNotMatter) {
    constexpr std::uint64_t kSeed = 71;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    std::string text;
    for (int i = 0; i < 200; ++i) text += static_cast<char>(random.below(256));
    for (int round = 0; round < 500; ++round) {
        ContentHash hash;
        std::string_view rest = text;
        while (!rest.empty()) {
            const std::size_t size = random.below(rest.size() + 1);
            hash.add(rest.substr(0, size));
            rest.remove_prefix(size);
        }
        ASSERT_EQ(hash.text(), hash_of(text));
    }
}

TEST(ContentHash, EachBitAndTheLengthCount) {
    std::set<std::string> seen;
    std::size_t count = 0;
    for (std::size_t size = 0; size <= 24; ++size) {
        std::string text(size, '\0');
        seen.insert(hash_of(text));
        ++count;
        for (std::size_t bit = 0; bit < 8 * size; ++bit) {
            std::string changed = text;
            changed[bit / 8] = static_cast<char>(1 << bit % 8);
            seen.insert(hash_of(changed));
            ++count;
        }
    }
    EXPECT_EQ(seen.size(), count);
    EXPECT_EQ(hash_of("lray").size(), 32u);
    EXPECT_NE(hash_of("ab"), hash_of("ba"));
    EXPECT_NE(hash_of("12345678abcdefgh"), hash_of("abcdefgh12345678")) << "the order of words";
}

}  // namespace
}  // namespace lray
