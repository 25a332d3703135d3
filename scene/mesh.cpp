// Finding the parts of a mesh by name.
#include "scene/mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lray::scene {

void index_parts(Mesh& mesh) {
    mesh.parts_by_name.resize(mesh.parts.size());
    std::iota(mesh.parts_by_name.begin(), mesh.parts_by_name.end(), 0u);
    std::sort(mesh.parts_by_name.begin(), mesh.parts_by_name.end(),
              [&](std::uint32_t a, std::uint32_t b) {
                  return std::tie(mesh.parts[a].name, a) < std::tie(mesh.parts[b].name, b);
              });
}

std::span<const std::uint32_t> parts_named(const Mesh& mesh, std::string_view name) {
    const auto is_before = [&](std::uint32_t part, std::string_view wanted) {
        return mesh.parts[part].name < wanted;
    };
    const auto is_behind = [&](std::string_view wanted, std::uint32_t part) {
        return wanted < mesh.parts[part].name;
    };
    const auto& order = mesh.parts_by_name;
    const auto first = std::lower_bound(order.begin(), order.end(), name, is_before);
    return {first, std::upper_bound(first, order.end(), name, is_behind)};
}

std::optional<std::size_t> material_run_at(const Mesh& mesh, std::size_t triangle) {
    const auto& runs = mesh.material_runs;
    const auto next = std::upper_bound(
        runs.begin(), runs.end(), triangle,
        [](std::size_t index, const MaterialRun& run) { return index < run.first_triangle; });
    if (next == runs.begin()) return std::nullopt;
    return static_cast<std::size_t>(next - runs.begin()) - 1;
}

}  // namespace lray::scene
