#include "scene/formats/obj_assemble.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "scene/formats/obj_names.h"
#include "scene/smooth_normals.h"
#include "scene/triangulate_polygon.h"

namespace lray::scene::obj {

namespace {

constexpr std::uint32_t kNone = Mesh::kNone;
constexpr IndexTriple kNoTriple = {kNone, kNone, kNone};

/// Puts the arrays of a member of all chunks one behind the other; those of a chunk that has none
/// are filled up to `size_of(chunk)`.
template <class T, class SizeOf>
std::vector<T> concatenate(std::vector<Chunk>& chunks, std::vector<T> Chunk::*member,
                           const SizeOf& size_of, const T& filler) {
    std::size_t total = 0;
    bool are_any = false;
    for (const Chunk& chunk : chunks) {
        total += size_of(chunk);
        are_any = are_any || !(chunk.*member).empty();
    }
    if (!are_any) return {};
    if (chunks.size() == 1) return std::move(chunks.front().*member);
    std::vector<T> all;
    all.reserve(total);
    for (Chunk& chunk : chunks) {
        std::vector<T> part = std::exchange(chunk.*member, {});
        all.insert(all.end(), part.begin(), part.end());
        if (part.empty()) all.resize(all.size() + size_of(chunk), filler);
    }
    return all;
}

/// Follows the statements that hold for faces.
class StateTracker {
 public:
    explicit StateTracker(Mesh& mesh) : mesh_(mesh) {}

    void change(std::size_t first_triangle, const StateChange& change) {
        // Only what a face follows counts.
        if (first_triangle != pending_at_) flush();
        pending_at_ = first_triangle;
        pending_.set(change.kind, change.statement);
    }

    void finish() {
        if (pending_at_ < mesh_.triangles.size()) flush();
        close_part(open_group_, mesh_.triangles.size());
        close_part(open_object_, mesh_.triangles.size());
    }

    std::span<const SmoothingRun> smoothing() const { return smoothing_; }

 private:
    static constexpr std::size_t kNoPart = std::numeric_limits<std::size_t>::max();

    void flush() {
        pending_.take([this](StateKind kind, const char* statement) {
            switch (kind) {
                case StateKind::object:
                    close_part(open_group_, pending_at_);
                    begin_part(open_object_, name_at(statement));
                    return;
                case StateKind::group:
                    begin_part(open_group_, name_at(statement));
                    return;
                case StateKind::material:
                    begin_material(name_at(statement));
                    return;
                case StateKind::smoothing:
                    smoothing_.push_back(
                        {static_cast<std::uint32_t>(pending_at_), smoothing_group_at(statement)});
                    return;
            }
        });
    }

    /// One begun again under its name goes on.
    void begin_part(std::size_t& open, std::string name) {
        if (name.empty()) name = "default";  // as the format calls the group of a `g` alone
        if (open != kNoPart && mesh_.parts[open].name == name) return;
        close_part(open, pending_at_);
        open = mesh_.parts.size();
        mesh_.parts.push_back({std::move(name), static_cast<std::uint32_t>(pending_at_), 0});
    }

    void close_part(std::size_t& open, std::size_t end) {
        if (open == kNoPart) return;
        MeshPart& part = mesh_.parts[open];
        part.triangle_count = static_cast<std::uint32_t>(end) - part.first_triangle;
        open = kNoPart;
    }

    void begin_material(const std::string& name) {
        std::uint32_t material = MaterialRun::kNone;
        if (!name.empty()) {
            const auto next = static_cast<std::uint32_t>(mesh_.material_names.size());
            const auto [known, is_new] = materials_.try_emplace(name, next);
            if (is_new) mesh_.material_names.push_back(name);
            material = known->second;
        }
        const std::uint32_t before =
            mesh_.material_runs.empty() ? MaterialRun::kNone : mesh_.material_runs.back().material;
        if (material == before) return;
        mesh_.material_runs.push_back({static_cast<std::uint32_t>(pending_at_), material});
    }

    Mesh& mesh_;
    PendingStates pending_{};
    std::size_t pending_at_ = 0;
    std::size_t open_object_ = kNoPart;
    std::size_t open_group_ = kNoPart;
    std::unordered_map<std::string, std::uint32_t> materials_{};
    std::vector<SmoothingRun> smoothing_{};
};

void add_material_files(const std::vector<Chunk>& chunks, Mesh& mesh) {
    std::vector<std::string>& files = mesh.material_files;
    for (const Chunk& chunk : chunks) {
        for (const char* const statement : chunk.libraries) {
            for (std::string& file : files_at(statement)) {
                if (files.size() > kMaxMaterialFiles) return;
                if (std::find(files.begin(), files.end(), file) != files.end()) continue;
                files.push_back(std::move(file));
            }
        }
    }
}

bool are_indices_in_range(const Mesh& mesh) {
    const auto count_needed = [](const std::vector<IndexTriple>& triples) {
        std::uint32_t count = 0;
        for (const IndexTriple& triple : triples) {
            for (const std::uint32_t index : triple) count = std::max(count, index + 1);  // none: 0
        }
        return count;
    };
    return count_needed(mesh.triangles) <= mesh.positions.size() &&
           count_needed(mesh.uv_indices) <= mesh.uvs.size() &&
           count_needed(mesh.normal_indices) <= mesh.normals.size();
}

/// Cuts again, now by shape, what was laid down as fans.
void triangulate(std::span<const LatePolygon> polygons, Mesh& mesh) {
    PolygonTriangulator triangulator;
    std::vector<Vec3> polygon;
    std::vector<IndexTriple> fan;
    for (const LatePolygon& late : polygons) {
        const auto corner_of = [&](const IndexTriple* triangles, std::size_t corner) {
            return corner < 2 ? triangles[0][corner] : triangles[corner - 2][2];
        };
        const std::size_t corner_count = std::size_t{late.triangle_count} + 2;
        polygon.clear();
        for (std::size_t i = 0; i < corner_count; ++i) {
            const std::uint32_t index = corner_of(&mesh.triangles[late.first_triangle], i);
            polygon.push_back(mesh.positions[index]);
        }
        const std::span<const IndexTriple> cut = triangulator.triangulate(polygon);
        for (auto* triples : {&mesh.triangles, &mesh.uv_indices, &mesh.normal_indices}) {
            if (triples->empty()) continue;
            IndexTriple* const first = triples->data() + late.first_triangle;
            fan.assign(first, first + late.triangle_count);
            for (std::size_t i = 0; i < cut.size(); ++i) {
                for (std::size_t k = 0; k < 3; ++k) first[i][k] = corner_of(fan.data(), cut[i][k]);
            }
        }
    }
}

void triangulate_late_polygons(const std::vector<LatePolygon>& polygons, Mesh& mesh) {
    constexpr std::size_t kGrain = std::size_t{1} << 14;
    const tbb::blocked_range<std::size_t> all(0, polygons.size(), kGrain);
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
        triangulate(std::span(polygons).subspan(range.begin(), range.size()), mesh);
    });
}

void forget_zero_normals(Mesh& mesh) {
    for (IndexTriple& triple : mesh.normal_indices) {
        const bool has_zero =
            triple[0] != kNone && std::any_of(triple.begin(), triple.end(), [&](auto index) {
                return mesh.normals[index] == Vec3(0.0f);
            });
        if (has_zero) triple = kNoTriple;
    }
}

}  // namespace

std::optional<Mesh> assemble(std::vector<Chunk> chunks) {
    Mesh mesh;
    std::vector<LatePolygon> late_polygons;
    std::vector<std::size_t> first_triangles;
    bool has_zero_normals = false;
    std::size_t triangle_count = 0;
    for (const Chunk& chunk : chunks) {
        first_triangles.push_back(triangle_count);
        for (const LatePolygon& late : chunk.late_polygons) {
            const std::size_t first = triangle_count + late.first_triangle;
            late_polygons.push_back({static_cast<std::uint32_t>(first), late.triangle_count});
        }
        triangle_count += chunk.triangles.size();
        has_zero_normals = has_zero_normals || chunk.has_zero_normals;
    }
    if (triangle_count == 0) return {};

    const auto positions_in = [](const Chunk& chunk) { return chunk.positions.size(); };
    const auto normals_in = [](const Chunk& chunk) { return chunk.normals.size(); };
    const auto uvs_in = [](const Chunk& chunk) { return chunk.uvs.size(); };
    const auto triangles_in = [](const Chunk& chunk) { return chunk.triangles.size(); };
    // What is filled up to the size of another array goes before it.
    mesh.colors = concatenate(chunks, &Chunk::colors, positions_in, Color{1.0f});
    mesh.positions = concatenate(chunks, &Chunk::positions, positions_in, Vec3{});
    mesh.normals = concatenate(chunks, &Chunk::normals, normals_in, Vec3{});
    mesh.uvs = concatenate(chunks, &Chunk::uvs, uvs_in, Vec2{});
    mesh.normal_indices = concatenate(chunks, &Chunk::normal_indices, triangles_in, kNoTriple);
    mesh.uv_indices = concatenate(chunks, &Chunk::uv_indices, triangles_in, kNoTriple);
    mesh.triangles = concatenate(chunks, &Chunk::triangles, triangles_in, kNoTriple);
    if (!are_indices_in_range(mesh)) return {};

    StateTracker states(mesh);
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        for (const StateChange& change : chunks[i].changes) {
            states.change(first_triangles[i] + change.first_triangle, change);
        }
    }
    states.finish();
    index_parts(mesh);
    add_material_files(chunks, mesh);
    triangulate_late_polygons(late_polygons, mesh);
    if (has_zero_normals) forget_zero_normals(mesh);
    smooth_by_groups(mesh, states.smoothing());
    return mesh;
}

}  // namespace lray::scene::obj
