#include "scene/smooth_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "base/portable_math.h"

namespace lray::scene {

namespace {

constexpr std::uint32_t kNone = Mesh::kNone;
constexpr IndexTriple kNoTriple = {kNone, kNone, kNone};

std::array<float, 3> key_of(Vec3 p) {
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};  // -0 becomes 0
}

/// Returns for each position the number of its point: equal positions are one point, and points
/// are numbered by their coordinates.
std::vector<std::uint32_t> weld(std::span<const Vec3> positions) {
    struct Entry {
        std::array<float, 3> key{};
        std::uint32_t index = 0;
    };
    std::vector<Entry> entries(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        entries[i] = {key_of(positions[i]), static_cast<std::uint32_t>(i)};
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.key < b.key; });
    std::vector<std::uint32_t> points(positions.size());
    std::uint32_t point = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i > 0 && entries[i].key != entries[i - 1].key) ++point;
        points[entries[i].index] = point;
    }
    return points;
}

/// Sets of corners that share a normal. The least corner of a set stands for it.
class CornerSets {
 public:
    explicit CornerSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0u);
    }

    std::uint32_t find(std::uint32_t corner) {
        while (parents_[corner] != corner) {
            parents_[corner] = parents_[parents_[corner]];
            corner = parents_[corner];
        }
        return corner;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a != b) parents_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<std::uint32_t> parents_;
};

/// The edge of a triangle from one of its corners to the next, filed under its lesser point.
struct EdgeUse {
    std::uint32_t other_point = 0;
    std::uint32_t corner = 0;  // 3 * triangle + 0, 1 or 2
};

std::uint32_t next_corner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Finds the corners that share a normal, and their normals.
class Smoother {
 public:
    explicit Smoother(const Mesh& mesh)
        : mesh_(mesh), points_(weld(mesh.positions)), sets_(3 * mesh.triangles.size()) {
        normals_.reserve(mesh.triangles.size());
        for (const IndexTriple& triple : mesh.triangles) normals_.push_back(normal_of(triple));
    }

    /// `takes_part(triangle)`: others stay as they are. `join_uses(uses)`: joins, by join(), those
    /// of one edge that are smooth; there are two at least.
    template <class TakesPart, class JoinUses>
    void run(const TakesPart& takes_part, const JoinUses& join_uses) {
        std::vector<std::size_t> firsts;
        std::vector<EdgeUse> uses = file_edges(takes_part, firsts);
        for (std::size_t point = 0; point + 1 < firsts.size(); ++point) {
            const auto begin = uses.begin() + static_cast<std::ptrdiff_t>(firsts[point]);
            const auto end = uses.begin() + static_cast<std::ptrdiff_t>(firsts[point + 1]);
            std::sort(begin, end, [](const EdgeUse& a, const EdgeUse& b) {
                return a.other_point != b.other_point ? a.other_point < b.other_point
                                                      : a.corner < b.corner;
            });
            for (auto edge = begin; edge != end;) {
                const auto edge_end = std::find_if(edge, end, [&](const EdgeUse& use) {
                    return use.other_point != edge->other_point;
                });
                if (edge_end - edge > 1) join_uses(std::span<EdgeUse>(edge, edge_end));
                edge = edge_end;
            }
        }
    }

    /// The corners of both uses at both ends of their edge share a normal.
    void join(const EdgeUse& a, const EdgeUse& b) {
        std::uint32_t first = b.corner;
        std::uint32_t second = next_corner(b.corner);
        if (point_of(a.corner) != point_of(first)) std::swap(first, second);
        sets_.join(a.corner, first);
        sets_.join(next_corner(a.corner), second);
    }

    /// Of the face that an edge is of; unit.
    DVec3 normal_at(const EdgeUse& use) const { return normals_[use.corner / 3]; }

    /// The point of the plane across the edge where the face's normal lies, seen from the lesser
    /// end of the edge.
    DVec2 around(const EdgeUse& use) const {
        const std::uint32_t next = next_corner(use.corner);
        const bool is_forward = point_of(use.corner) < point_of(next);
        const DVec3 from = position(is_forward ? use.corner : next);
        const DVec3 along = position(is_forward ? next : use.corner) - from;
        // Two axes across: one, any that is not along the edge, made by the least component.
        const DVec3 size{std::fabs(along.x), std::fabs(along.y), std::fabs(along.z)};
        const DVec3 least = size.x <= size.y && size.x <= size.z ? DVec3{1.0, 0.0, 0.0}
                            : size.y <= size.z                   ? DVec3{0.0, 1.0, 0.0}
                                                                 : DVec3{0.0, 0.0, 1.0};
        const DVec3 u = cross(along, least);
        const DVec3 v = cross(along, u);
        const DVec3 n = normal_at(use);
        return {dot(n, u) / std::sqrt(dot(u, u)), dot(n, v) / std::sqrt(dot(v, v))};
    }

    /// Replaces the normals of the triangles that were joined with others.
    void write(Mesh& mesh) {
        number_sets();
        add_up();
        const auto first_normal = static_cast<std::uint32_t>(mesh.normals.size());
        for (const Sum& sum : sums_) mesh.normals.push_back(mean(sum));
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            IndexTriple triple{};
            for (std::uint32_t i = 0; i < 3; ++i) {
                triple[i] = numbers_[sets_.find(3 * triangle + i)];
            }
            if (triple == kNoTriple) continue;
            if (mesh.normal_indices.empty()) {
                mesh.normal_indices.resize(mesh.triangles.size(), kNoTriple);
            }
            if (std::find(triple.begin(), triple.end(), kNone) != triple.end()) {
                mesh.normals.push_back(Vec3{normals_[triangle]});
            }
            bool is_whole = true;
            for (std::uint32_t& number : triple) {
                number = number == kNone ? static_cast<std::uint32_t>(mesh.normals.size() - 1)
                                         : first_normal + number;
                is_whole = is_whole && mesh.normals[number] != Vec3{0.0f};
            }
            mesh.normal_indices[triangle] = is_whole ? triple : kNoTriple;
        }
    }

 private:
    /// Weights are in [0, 1] of the largest at their corner: as integers they add up to the same in
    /// any order, and those of 2^30 corners fit.
    static constexpr double kWeightScale = 0x1p32;

    /// Of a set of more than one corner.
    struct Sum {
        std::int64_t x = 0;
        std::int64_t y = 0;
        std::int64_t z = 0;
        float largest_weight = 0.0f;
    };

    std::uint32_t point_of(std::uint32_t corner) const {
        return points_[mesh_.triangles[corner / 3][corner % 3]];
    }
    DVec3 position(std::uint32_t corner) const {
        return DVec3{mesh_.positions[mesh_.triangles[corner / 3][corner % 3]]};
    }

    /// 0 of a triangle without area.
    DVec3 normal_of(const IndexTriple& triple) const {
        const DVec3 a{mesh_.positions[triple[0]]};
        const DVec3 normal =
            cross(DVec3{mesh_.positions[triple[1]]} - a, DVec3{mesh_.positions[triple[2]]} - a);
        const double largest =
            std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
        if (!(largest > 0.0) || !std::isfinite(largest)) return DVec3{0.0};
        const DVec3 scaled = normal / largest;
        return scaled / std::sqrt(dot(scaled, scaled));
    }

    /// Sorts the edges of triangles into those of each lesser point: `firsts` says where they
    /// begin.
    template <class TakesPart>
    std::vector<EdgeUse> file_edges(const TakesPart& takes_part, std::vector<std::size_t>& firsts) {
        std::uint32_t point_count = 0;
        for (const std::uint32_t point : points_) point_count = std::max(point_count, point + 1);
        firsts.assign(std::size_t{point_count} + 2, 0);
        const auto each_edge = [&](const auto& use) {
            for (std::uint32_t triangle = 0; triangle < mesh_.triangles.size(); ++triangle) {
                if (normals_[triangle] == DVec3{0.0} || !takes_part(triangle)) continue;
                for (std::uint32_t i = 0; i < 3; ++i) {
                    const std::uint32_t corner = 3 * triangle + i;
                    const std::uint32_t a = point_of(corner);
                    const std::uint32_t b = point_of(next_corner(corner));
                    use(std::min(a, b), EdgeUse{std::max(a, b), corner});
                }
            }
        };
        // Two places further on, so that filling them in moves each to where it belongs.
        each_edge([&](std::uint32_t point, const EdgeUse&) { ++firsts[point + 2]; });
        std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
        std::vector<EdgeUse> uses(firsts.back());
        each_edge(
            [&](std::uint32_t point, const EdgeUse& use) { uses[firsts[point + 1]++] = use; });
        firsts.pop_back();
        return uses;
    }

    /// Of the corner, in turns.
    double angle_at(std::uint32_t corner) const {
        const std::uint32_t next = next_corner(corner);
        const DVec3 p = position(corner);
        const DVec3 a = position(next) - p;
        const DVec3 b = position(next_corner(next)) - p;
        const DVec3 across = cross(a, b);
        return turns_of({dot(a, b), std::sqrt(dot(across, across))});
    }

    void number_sets() {
        const auto corner_count = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
        numbers_.assign(corner_count, kNone);
        std::uint32_t count = 0;
        for (std::uint32_t corner = 0; corner < corner_count; ++corner) {
            const std::uint32_t set = sets_.find(corner);
            if (set != corner && numbers_[set] == kNone) numbers_[set] = count++;
        }
        sums_.assign(count, {});
    }

    void add_up() {
        std::vector<float> weights(numbers_.size());
        const auto each_corner = [&](const auto& use) {
            for (std::uint32_t corner = 0; corner < weights.size(); ++corner) {
                const std::uint32_t number = numbers_[sets_.find(corner)];
                if (number != kNone) use(corner, sums_[number]);
            }
        };
        each_corner([&](std::uint32_t corner, Sum& sum) {
            weights[corner] = static_cast<float>(angle_at(corner));
            sum.largest_weight = std::max(sum.largest_weight, weights[corner]);
        });
        each_corner([&](std::uint32_t corner, Sum& sum) {
            if (!(weights[corner] > 0.0f)) return;
            const double weight =
                double{weights[corner]} / double{sum.largest_weight} * kWeightScale;
            const DVec3 share = weight * normals_[corner / 3];
            sum.x += static_cast<std::int64_t>(share.x);
            sum.y += static_cast<std::int64_t>(share.y);
            sum.z += static_cast<std::int64_t>(share.z);
        });
    }

    /// 0 if the faces cancel out.
    static Vec3 mean(const Sum& sum) {
        const DVec3 direction{static_cast<double>(sum.x), static_cast<double>(sum.y),
                              static_cast<double>(sum.z)};
        const double length = std::sqrt(dot(direction, direction));
        // What is left of faces that cancel out is rounding.
        return length < 0x1p-20 * kWeightScale ? Vec3{0.0f} : Vec3{direction / length};
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t> points_;
    CornerSets sets_;
    std::vector<DVec3> normals_{};          // by triangle; 0 of one without area
    std::vector<std::uint32_t> numbers_{};  // of sums_, by the corner that stands for a set
    std::vector<Sum> sums_{};
};

/// The normals of all faces at an edge lie in one plane: sorted around the edge, those that are
/// smooth with any are so with a neighbour.
void join_around(Smoother& smoother, std::span<EdgeUse> uses, double least_cosine) {
    const auto join_if_smooth = [&](const EdgeUse& a, const EdgeUse& b) {
        if (dot(smoother.normal_at(a), smoother.normal_at(b)) > least_cosine) smoother.join(a, b);
    };
    if (uses.size() == 2) return join_if_smooth(uses[0], uses[1]);
    std::vector<std::pair<double, EdgeUse>> around;
    around.reserve(uses.size());
    for (const EdgeUse& use : uses) around.emplace_back(turns_of(smoother.around(use)), use);
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first < b.first : a.second.corner < b.second.corner;
    });
    for (std::size_t i = 0; i < around.size(); ++i) {
        join_if_smooth(around[i].second, around[(i + 1) % around.size()].second);
    }
}

}  // namespace

void smooth_by_angle(Mesh& mesh, double angle) {
    mesh.normals.clear();
    mesh.normal_indices.clear();
    if (!(angle > 0.0)) return;
    const double turns = std::min(angle / (2.0 * std::numbers::pi), 0.5);
    const double least_cosine = unit_circle_point(turns).x;
    Smoother smoother(mesh);
    smoother.run([](std::uint32_t) { return true; },
                 [&](std::span<EdgeUse> uses) { join_around(smoother, uses, least_cosine); });
    smoother.write(mesh);
}

void smooth_by_groups(Mesh& mesh, std::span<const SmoothingRun> runs) {
    const bool is_any = std::any_of(runs.begin(), runs.end(),
                                    [](const SmoothingRun& run) { return run.group != 0; });
    if (!is_any) return;
    const auto has_normals = [&](std::size_t triangle) {
        return !mesh.normal_indices.empty() && mesh.normal_indices[triangle][0] != kNone;
    };
    std::vector<std::uint32_t> groups(mesh.triangles.size(), 0);
    bool is_any_without = false;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const std::size_t end =
            run + 1 < runs.size() ? runs[run + 1].first_triangle : mesh.triangles.size();
        for (std::size_t i = runs[run].first_triangle; i < end; ++i) {
            if (runs[run].group == 0 || has_normals(i)) continue;
            groups[i] = runs[run].group;
            is_any_without = true;
        }
    }
    if (!is_any_without) return;
    const auto group_of = [&](const EdgeUse& use) { return groups[use.corner / 3]; };
    Smoother smoother(mesh);
    smoother.run([&](std::uint32_t triangle) { return groups[triangle] != 0; },
                 [&](std::span<EdgeUse> uses) {
                     std::sort(uses.begin(), uses.end(), [&](const EdgeUse& a, const EdgeUse& b) {
                         return group_of(a) != group_of(b) ? group_of(a) < group_of(b)
                                                           : a.corner < b.corner;
                     });
                     for (std::size_t i = 1; i < uses.size(); ++i) {
                         if (group_of(uses[i]) == group_of(uses[i - 1])) {
                             smoother.join(uses[i - 1], uses[i]);
                         }
                     }
                 });
    smoother.write(mesh);
}

}  // namespace lray::scene
