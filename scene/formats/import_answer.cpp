#include "scene/formats/import_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "image/srgb.h"

namespace lray::scene {

namespace {

constexpr IndexTriple kNoTriple = {Mesh::kNone, Mesh::kNone, Mesh::kNone};

/// Makes room for some more. A vector that is told its size for each of many small parts would move
/// all it holds each time: it at least doubles instead.
template <class T>
void reserve_more(std::vector<T>& values, std::size_t count) {
    const std::size_t needed = values.size() + count;
    if (needed > values.capacity()) values.reserve(std::max(needed, 2 * values.capacity()));
}

class AnswerReader {
 public:
    AnswerReader(std::span<const char> bytes, ColorCoding coding) : rest_(bytes), coding_(coding) {}

    std::optional<std::variant<Mesh, ImportFailure>> read();

 private:
    struct PartHeader {
        std::uint32_t name_size = 0;
        std::uint32_t vertex_count = 0;
        std::uint32_t triangle_count = 0;
        std::uint32_t has = 0;
    };

    template <class T>
    bool take(T& value) {
        if (rest_.size() < sizeof(T)) return false;
        std::memcpy(&value, rest_.data(), sizeof(T));
        rest_ = rest_.subspan(sizeof(T));
        return true;
    }
    template <class T>
    T take_known() {  // of bytes that were counted before
        T value{};
        std::memcpy(&value, rest_.data(), sizeof(T));
        rest_ = rest_.subspan(sizeof(T));
        return value;
    }
    std::optional<std::string> take_text(std::uint32_t size);

    bool read_part();
    bool read_positions(std::uint32_t count);
    void read_normals(std::uint32_t count);
    void read_uvs(std::uint32_t count);
    void read_colors(std::uint32_t count);
    bool read_triangles(const PartHeader& part, const Mesh& before);
    std::optional<ImportFailure> read_failure();

    std::span<const char> rest_;
    ColorCoding coding_;
    Mesh mesh_{};
    std::size_t first_position_ = 0;  // of the part; likewise below
    std::size_t first_normal_ = 0;
    std::size_t first_uv_ = 0;
};

std::optional<std::variant<Mesh, ImportFailure>> AnswerReader::read() {
    std::uint32_t magic = 0;
    if (!take(magic) || magic != wire::kMagic) return {};
    for (;;) {
        std::uint32_t tag = 0;
        if (!take(tag)) return {};
        if (tag == wire::kPart) {
            if (!read_part()) return {};
        } else if (tag == wire::kEnd) {
            if (!rest_.empty()) return {};
            index_parts(mesh_);
            return std::move(mesh_);
        } else if (tag == wire::kFailure) {
            std::optional<ImportFailure> failure = read_failure();
            if (!failure) return {};
            return std::move(*failure);
        } else {
            return {};
        }
    }
}

std::optional<std::string> AnswerReader::take_text(std::uint32_t size) {
    if (size > wire::kMaxTextSize || size > rest_.size()) return {};
    std::string text(rest_.data(), size);
    rest_ = rest_.subspan(size);
    return text;
}

bool AnswerReader::read_part() {
    PartHeader part;
    if (!take(part.name_size) || !take(part.vertex_count) || !take(part.triangle_count) ||
        !take(part.has) || (part.has & ~wire::kHasAll) != 0) {
        return false;
    }
    std::optional<std::string> name = take_text(part.name_size);
    if (!name) return false;
    const bool has_normals = (part.has & wire::kHasNormals) != 0;
    const bool has_uvs = (part.has & wire::kHasUvs) != 0;
    const bool has_colors = (part.has & wire::kHasColors) != 0;
    const std::uint64_t vertex_floats =
        3 + (has_normals ? 3 : 0) + (has_uvs ? 2 : 0) + (has_colors ? 3 : 0);
    const std::uint64_t size = sizeof(float) * vertex_floats * part.vertex_count +
                               sizeof(IndexTriple) * std::uint64_t{part.triangle_count};
    if (size > rest_.size()) return false;
    first_position_ = mesh_.positions.size();
    first_normal_ = mesh_.normals.size();
    first_uv_ = mesh_.uvs.size();
    if (first_position_ + part.vertex_count >= Mesh::kNone ||
        mesh_.triangles.size() + part.triangle_count >= Mesh::kNone) {
        return false;
    }
    const auto first_triangle = static_cast<std::uint32_t>(mesh_.triangles.size());
    if (!read_positions(part.vertex_count)) return false;
    if (has_normals) read_normals(part.vertex_count);
    if (has_uvs) read_uvs(part.vertex_count);
    if (has_colors) {
        mesh_.colors.resize(first_position_, Color{1.0f});
        read_colors(part.vertex_count);
    } else if (!mesh_.colors.empty()) {
        mesh_.colors.resize(mesh_.positions.size(), Color{1.0f});
    }
    if (!read_triangles(part, mesh_)) return false;
    if (part.triangle_count > 0 && !name->empty()) {
        mesh_.parts.push_back({std::move(*name), first_triangle, part.triangle_count});
    }
    return true;
}

bool AnswerReader::read_positions(std::uint32_t count) {
    reserve_more(mesh_.positions, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto p = take_known<std::array<float, 3>>();
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return false;
        mesh_.positions.emplace_back(p[0], p[1], p[2]);
    }
    return true;
}

void AnswerReader::read_normals(std::uint32_t count) {
    reserve_more(mesh_.normals, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto n = take_known<std::array<float, 3>>();
        const DVec3 normal(n[0], n[1], n[2]);
        const double length = std::sqrt(dot(normal, normal));
        const bool is_one = length > 0.0 && std::isfinite(length);
        mesh_.normals.push_back(is_one ? Vec3(normal / length) : Vec3(0.0f));
    }
}

void AnswerReader::read_uvs(std::uint32_t count) {
    reserve_more(mesh_.uvs, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto uv = take_known<std::array<float, 2>>();
        const bool is_finite = std::isfinite(uv[0]) && std::isfinite(uv[1]);
        mesh_.uvs.push_back(is_finite ? Vec2(uv[0], uv[1]) : Vec2(0.0f));
    }
}

void AnswerReader::read_colors(std::uint32_t count) {
    reserve_more(mesh_.colors, count);
    const auto linear = [&](float code) {
        if (coding_ == ColorCoding::srgb) {
            return static_cast<float>(image::srgb_decode(static_cast<double>(code)));
        }
        return code > 0.0f ? std::min(code, 1.0f) : 0.0f;
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto c = take_known<std::array<float, 3>>();
        mesh_.colors.emplace_back(linear(c[0]), linear(c[1]), linear(c[2]));
    }
}

bool AnswerReader::read_triangles(const PartHeader& part, const Mesh& before) {
    const bool has_normals = (part.has & wire::kHasNormals) != 0;
    const bool has_uvs = (part.has & wire::kHasUvs) != 0;
    const std::size_t first = before.triangles.size();
    reserve_more(mesh_.triangles, part.triangle_count);
    const auto moved = [](const IndexTriple& triple, std::size_t by) {
        const auto offset = static_cast<std::uint32_t>(by);
        return IndexTriple{triple[0] + offset, triple[1] + offset, triple[2] + offset};
    };
    if (has_normals) mesh_.normal_indices.resize(first, kNoTriple);
    if (has_uvs) mesh_.uv_indices.resize(first, kNoTriple);
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
        const auto triple = take_known<IndexTriple>();
        if (std::max({triple[0], triple[1], triple[2]}) >= part.vertex_count) return false;
        mesh_.triangles.push_back(moved(triple, first_position_));
        if (has_normals) {
            const bool has_all = std::none_of(triple.begin(), triple.end(), [&](auto index) {
                return mesh_.normals[first_normal_ + index] == Vec3(0.0f);
            });
            mesh_.normal_indices.push_back(has_all ? moved(triple, first_normal_) : kNoTriple);
        }
        if (has_uvs) mesh_.uv_indices.push_back(moved(triple, first_uv_));
    }
    if (!mesh_.normal_indices.empty()) {
        mesh_.normal_indices.resize(mesh_.triangles.size(), kNoTriple);
    }
    if (!mesh_.uv_indices.empty()) mesh_.uv_indices.resize(mesh_.triangles.size(), kNoTriple);
    return true;
}

std::optional<ImportFailure> AnswerReader::read_failure() {
    std::uint32_t kind = 0;
    std::uint32_t size = 0;
    if (!take(kind) || !take(size)) return {};
    const std::optional<std::string> reason = take_text(size);
    const bool is_known = kind == static_cast<std::uint32_t>(wire::Failure::not_understood) ||
                          kind == static_cast<std::uint32_t>(wire::Failure::out_of_memory);
    if (!reason || !rest_.empty() || !is_known) return {};
    return ImportFailure{static_cast<wire::Failure>(kind), *reason};
}

}  // namespace

std::optional<std::variant<Mesh, ImportFailure>> read_import_answer(std::span<const char> bytes,
                                                                    ColorCoding coding) {
    return AnswerReader(bytes, coding).read();
}

}  // namespace lray::scene
