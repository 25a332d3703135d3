// read_import_answer: what an importer writes is read, or not believed.
#include "scene/formats/import_answer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "image/srgb.h"

namespace lray::scene {
namespace {

class Bytes {
 public:
    Bytes& words(std::initializer_list<std::uint32_t> all) {
        for (const std::uint32_t word : all) add(word);
        return *this;
    }
    Bytes& floats(std::initializer_list<float> all) {
        for (const float number : all) add(number);
        return *this;
    }
    Bytes& text(std::string_view text) {
        bytes_ += text;
        return *this;
    }
    const std::string& all() const { return bytes_; }

 private:
    template <class T>
    void add(T value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    std::string bytes_;
};

std::optional<Mesh> mesh_in(const std::string& bytes, ColorCoding coding = ColorCoding::linear) {
    auto answer = read_import_answer(bytes, coding);
    if (!answer || !std::holds_alternative<Mesh>(*answer)) return {};
    return std::get<Mesh>(std::move(*answer));
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kNone = Mesh::kNone;

/// A part without anything but positions, then one with everything.
Bytes two_parts() {
    Bytes bytes;
    bytes.words({wire::kMagic, wire::kPart, 1, 3, 1, 0}).text("a");
    bytes.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}).words({0, 1, 2});
    bytes.words({wire::kPart, 2, 4, 2, wire::kHasAll}).text("bc");
    bytes.floats({0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1});
    bytes.floats({0, 0, 2, 0, 3, 0, 1, 0, 0, kNan, 0, 0});
    bytes.floats({0, 0, 1, 0, 0, 1, kNan, 1});
    bytes.floats({1, 0, 0.5f, 0, 2, 0, 0, -1, 0, kNan, 0, 0});
    bytes.words({0, 1, 2, 1, 3, 2});
    return bytes;
}

TEST(ImportAnswer, PartsWithAndWithoutAttributes) {
    const auto mesh = mesh_in(two_parts().words({wire::kEnd}).all());
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->positions.size(), 7u);
    EXPECT_EQ(mesh->triangles, (std::vector<IndexTriple>{{0, 1, 2}, {3, 4, 5}, {4, 6, 5}}));
    EXPECT_EQ(mesh->normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
    EXPECT_EQ(mesh->normal_indices,
              (std::vector<IndexTriple>{{kNone, kNone, kNone}, {0, 1, 2}, {kNone, kNone, kNone}}));
    EXPECT_EQ(mesh->uvs, (std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}, {0, 0}}));
    EXPECT_EQ(mesh->uv_indices,
              (std::vector<IndexTriple>{{kNone, kNone, kNone}, {0, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(mesh->colors,
              (std::vector<Color>{
                  {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 0, 0.5f}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}}));
    ASSERT_EQ(mesh->parts.size(), 2u);
    EXPECT_EQ(mesh->parts[1].name, "bc");
    EXPECT_EQ(mesh->parts[1].first_triangle, 1u);
    EXPECT_EQ(mesh->parts[1].triangle_count, 2u);
}

// Time that grows with the square of their number would be half a minute.
/// Each part makes the arrays longer, which must not copy them each time.
TEST(ImportAnswer, ManySmallPartsAreOneMesh) {
    constexpr std::uint32_t kParts = 200'000;
    Bytes bytes;
    bytes.words({wire::kMagic});
    for (std::uint32_t i = 0; i < kParts; ++i) {
        bytes.words({wire::kPart, 1, 3, 1, wire::kHasAll}).text("a");
        for (int vertex = 0; vertex < 3; ++vertex) {
            bytes.floats({static_cast<float>(i), 0, 0, 0, 0, 1, 0, 0, 1, 1, 1});
        }
        bytes.words({0, 1, 2});
    }
    bytes.words({wire::kEnd});
    const auto mesh = mesh_in(bytes.all());
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->positions.size(), 3 * kParts);
    EXPECT_EQ(mesh->triangles.back(),
              (IndexTriple{3 * kParts - 3, 3 * kParts - 2, 3 * kParts - 1}));
    EXPECT_EQ(mesh->parts.size(), kParts);
}

TEST(ImportAnswer, ColoursOfAScreenAreDecoded) {
    const auto mesh = mesh_in(two_parts().words({wire::kEnd}).all(), ColorCoding::srgb);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->colors[3].b, static_cast<float>(image::srgb_decode(0.5)));
}

TEST(ImportAnswer, NoPrefixIsBelieved) {
    const std::string whole = two_parts().words({wire::kEnd}).all();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(
            read_import_answer(std::string_view(whole).substr(0, size), ColorCoding::linear))
            << size;
    }
    EXPECT_FALSE(mesh_in(whole + "x"));
}

TEST(ImportAnswer, SizesBeyondTheBytes) {
    constexpr std::uint32_t kHuge = 0xffffffffu;
    EXPECT_FALSE(mesh_in(Bytes().words({wire::kMagic, wire::kPart, 0, kHuge, 0, 0}).all()));
    EXPECT_FALSE(mesh_in(Bytes().words({wire::kMagic, wire::kPart, 0, 0, kHuge, 0}).all()));
    EXPECT_FALSE(mesh_in(Bytes().words({wire::kMagic, wire::kPart, kHuge, 0, 0, 0}).all()));
    EXPECT_FALSE(mesh_in(Bytes().words({wire::kMagic, wire::kPart, 0, 0, 0, 8}).all()));
    EXPECT_FALSE(mesh_in(Bytes().words({wire::kMagic, 9}).all()));
}

TEST(ImportAnswer, VerticesThatDoNotExistOrHaveNoPlace) {
    const auto part = [](float x, std::uint32_t index) {
        Bytes bytes;
        bytes.words({wire::kMagic, wire::kPart, 0, 3, 1, 0}).floats({0, 0, 0, x, 0, 0, 0, 1, 0});
        return bytes.words({0, 1, index, wire::kEnd}).all();
    };
    EXPECT_TRUE(mesh_in(part(1.0f, 2)));
    EXPECT_FALSE(mesh_in(part(1.0f, 3)));
    EXPECT_FALSE(mesh_in(part(kNan, 2)));
}

TEST(ImportAnswer, Failures) {
    const auto failure = [](std::uint32_t kind, std::uint32_t size, std::string_view text) {
        return read_import_answer(
            Bytes().words({wire::kMagic, wire::kFailure, kind, size}).text(text).all(),
            ColorCoding::linear);
    };
    const auto answer = failure(2, 3, "why");
    ASSERT_TRUE(answer && std::holds_alternative<ImportFailure>(*answer));
    EXPECT_EQ(std::get<ImportFailure>(*answer).reason, "why");
    EXPECT_EQ(std::get<ImportFailure>(*answer).kind, wire::Failure::out_of_memory);
    EXPECT_FALSE(failure(3, 3, "why"));
    EXPECT_FALSE(failure(1, 4, "why"));
    EXPECT_FALSE(failure(1, 2, "why"));
    EXPECT_FALSE(failure(1, wire::kMaxTextSize + 1, std::string(wire::kMaxTextSize + 1, 'x')));
}

}  // namespace
}  // namespace lray::scene
