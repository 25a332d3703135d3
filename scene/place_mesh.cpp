// Placing meshes: vertices are transformed once each, however many triangles share them.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "base/assert.h"
#include "scene/content_map.h"
#include "scene/placer.h"

namespace lray::scene {

namespace {

/// Renumbers the elements of an array that some triangles refer to, without gaps. Never more than
/// three for each triangle: a file with a few faces and endless vertices costs nothing.
class UsedElements {
 public:
    /// Triples that begin with kNone refer to nothing.
    UsedElements(std::span<const IndexTriple> triples, std::size_t element_count)
        : element_count_(element_count) {
        if (element_count <= 3 * triples.size()) {
            is_all_ = true;
            for (const IndexTriple& triple : triples) {
                for (const std::uint32_t index : triple) {
                    LRAY_ASSERT(triple[0] == Mesh::kNone || index < element_count);
                }
            }
            return;
        }
        for (const IndexTriple& triple : triples) {
            if (triple[0] == Mesh::kNone) continue;
            used_.insert(used_.end(), triple.begin(), triple.end());
        }
        std::sort(used_.begin(), used_.end());
        used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
        LRAY_ASSERT(used_.empty() || used_.back() < element_count);
    }

    std::size_t size() const { return is_all_ ? element_count_ : used_.size(); }

    /// The element that has the new number i.
    std::size_t element(std::size_t i) const { return is_all_ ? i : used_[i]; }

    /// The new number of an element that is used.
    std::uint32_t number(std::uint32_t element) const {
        if (is_all_) return element;
        const auto found = std::lower_bound(used_.begin(), used_.end(), element);
        return static_cast<std::uint32_t>(found - used_.begin());
    }

 private:
    std::size_t element_count_ = 0;
    bool is_all_ = false;
    std::vector<std::uint32_t> used_;
};

/// Returns the triple renumbered, `base` added, and turned around if mirrored.
IndexTriple renumber(const UsedElements& used, const IndexTriple& triple, std::size_t base,
                     bool is_mirrored) {
    const auto at = [&](std::size_t i) {
        return static_cast<std::uint32_t>(base + used.number(triple[i]));
    };
    return is_mirrored ? IndexTriple{at(0), at(2), at(1)} : IndexTriple{at(0), at(1), at(2)};
}

std::span<const IndexTriple> slice(const std::vector<IndexTriple>& triples, TriangleRange range) {
    if (triples.empty()) return {};
    return std::span{triples}.subspan(range.first, range.count);
}

/// Which material of the file the triangles of a mesh have, one after the other: its number, or
/// the number of materials where there is none.
class MaterialWalk {
 public:
    MaterialWalk(const Mesh& mesh, bool are_shown, std::size_t first_triangle)
        : mesh_(mesh), are_shown_(are_shown && !mesh.material_runs.empty()) {
        if (!are_shown_) return;
        const auto run = material_run_at(mesh, first_triangle);
        next_run_ = run ? *run + 1 : 0;
        if (run) number_ = number_of(mesh.material_runs[*run]);
    }

    std::size_t number() const { return number_; }

    /// Goes on to a triangle; true if the number is another one.
    bool advance(std::size_t triangle) {
        if (!are_shown_) return false;
        const std::size_t before = number_;
        while (next_run_ < mesh_.material_runs.size() &&
               mesh_.material_runs[next_run_].first_triangle <= triangle) {
            number_ = number_of(mesh_.material_runs[next_run_]);
            ++next_run_;
        }
        return number_ != before;
    }

 private:
    std::size_t number_of(const MaterialRun& run) const {
        const bool is_defined =
            run.material != MaterialRun::kNone && !mesh_.materials[run.material].is_none();
        return is_defined ? run.material : mesh_.materials.size();
    }

    const Mesh& mesh_;
    bool are_shown_ = false;
    std::size_t next_run_ = 0;
    std::size_t number_ = mesh_.materials.size();
};

Color mean_color(std::span<const Color> colors) {
    DVec3 sum{0.0};
    for (const Color color : colors) sum += DVec3{color};
    return Color{sum / static_cast<double>(colors.size())};
}

DVec3 turn_up(Vec3 v, bool z_is_up) {
    const DVec3 d{v};
    return z_is_up ? DVec3{d.x, d.z, -d.y} : d;
}

}  // namespace

void Placer::place_mesh(NodeId node_id, const Placement& placement) {
    const MeshUse& use = scene_.mesh_uses[scene_.node(node_id).index];
    const Mesh& mesh = scene_.meshes[use.mesh_id.index()];
    mesh_objects_.clear();
    mesh_mean_color_.reset();
    if (scene_.shows_vertex_colors && !mesh.colors.empty()) {
        mesh_mean_color_ = mean_color(mesh.colors);
    }
    for (const TriangleRange range : triangles_of(scene_, use)) {
        place_triangles(node_id, range, placement);
    }
}

/// Makes `object_id_` the one of a mesh's triangles of a material; `number` counts those of the
/// file, the last one is for triangles that have none of it. False if it was refused.
bool Placer::enter_material(NodeId node_id, std::size_t number, const Placement& placement) {
    if (const auto known = mesh_objects_.find(number); known != mesh_objects_.end()) {
        object_id_ = known->second;
        return true;
    }
    const Mesh& mesh = scene_.meshes[scene_.mesh_uses[scene_.node(node_id).index].mesh_id.index()];
    Placement own = placement;
    if (number < mesh.materials.size()) own.material = mesh.materials[number].value + 1;
    if (!begin_object(node_id, own)) return false;
    geometry_.objects[object_id_.index()].is_continued = !mesh_objects_.empty();
    mesh_objects_.emplace(number, object_id_);
    if (mesh_mean_color_) {
        geometry_.mean_colors.resize(object_id_.index(), Color{1.0f});
        geometry_.mean_colors.push_back(*mesh_mean_color_);
    }
    return true;
}

void Placer::place_triangles(NodeId node_id, TriangleRange range, const Placement& placement) {
    const Node& node = scene_.node(node_id);
    const MeshUse& use = scene_.mesh_uses[node.index];
    const Mesh& mesh = scene_.meshes[use.mesh_id.index()];
    MaterialWalk materials(mesh, has_materials(scene_, use), range.first);
    if (!enter_material(node_id, materials.number(), placement)) return;
    const Transform& transform = placement.world_from_object;
    const auto triangles = slice(mesh.triangles, range);
    const auto normal_triples = slice(mesh.normal_indices, range);
    const auto uv_triples = slice(mesh.uv_indices, range);

    const UsedElements positions(triangles, mesh.positions.size());
    const std::size_t first_vertex = geometry_.vertices.size();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const DVec3 p = transform.point(turn_up(mesh.positions[positions.element(i)], use.z_is_up));
        if (!are_placeable(node, {&p, 1})) return;
        geometry_.vertices.push_back(Vec3{p});
    }

    if (mesh_mean_color_) {
        geometry_.colors.resize(first_vertex, Color{1.0f});
        for (std::size_t i = 0; i < positions.size(); ++i) {
            geometry_.colors.push_back(mesh.colors[positions.element(i)]);
        }
    }

    const UsedElements normals(normal_triples, mesh.normals.size());
    const std::size_t first_normal = geometry_.normals.size();
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vec3 normal = mesh.normals[normals.element(i)];
        // 0 stands for a normal that has no direction: triangles that use it are facetted.
        geometry_.normals.push_back(
            Vec3{unit(transform.normal(turn_up(normal, use.z_is_up))).value_or(DVec3{0.0})});
    }

    const UsedElements uvs(uv_triples, mesh.uvs.size());
    const std::size_t first_uv = geometry_.uvs.size();
    for (std::size_t i = 0; i < uvs.size(); ++i) geometry_.uvs.push_back(mesh.uvs[uvs.element(i)]);

    std::size_t dropped_count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const IndexTriple vertices =
            renumber(positions, triangles[i], first_vertex, placement.is_mirrored);
        if (is_degenerate(geometry_.vertices[vertices[0]], geometry_.vertices[vertices[1]],
                          geometry_.vertices[vertices[2]])) {
            ++dropped_count;
            continue;
        }
        if (materials.advance(range.first + i) &&
            !enter_material(node_id, materials.number(), placement)) {
            return;
        }
        geometry_.triangles.push_back({vertices});
        add_object_id(PrimitiveKind::triangle);
        if (!normal_triples.empty() && normal_triples[i][0] != Mesh::kNone) {
            const IndexTriple triple =
                renumber(normals, normal_triples[i], first_normal, placement.is_mirrored);
            const bool are_usable = std::none_of(triple.begin(), triple.end(), [&](auto index) {
                return geometry_.normals[index] == Vec3{0.0f};
            });
            if (are_usable) set_triangle_normals(triple);
        }
        if (!uv_triples.empty() && uv_triples[i][0] != Mesh::kNone) {
            set_triangle_uvs(renumber(uvs, uv_triples[i], first_uv, placement.is_mirrored));
        }
    }
    if (dropped_count > 0) {
        diagnostics_.warning(
            Code::W1702, node.span,
            fmt::format("{} of the {} faces of this mesh {} no area and {} dropped", dropped_count,
                        triangles.size(), dropped_count == 1 ? "has" : "have",
                        dropped_count == 1 ? "is" : "are"));
    }
}

}  // namespace lray::scene
