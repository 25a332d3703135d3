#include "parser/blocks/build_heightfield.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/random.h"
#include "parser/blocks/schemas.h"
#include "scene/height_grid.h"
#include "scene/terrain.h"

namespace lray::parser {

namespace {

using namespace schemas;

constexpr std::size_t kSize = slot(kHeightfield, "size");
constexpr std::size_t kResolutionSlot = slot(kHeightfield, "resolution");
constexpr std::size_t kHeight = slot(kHeightfield, "height");
constexpr std::size_t kHeights = slot(kHeightfield, "heights");
constexpr std::size_t kImage = slot(kHeightfield, "image");
constexpr std::size_t kScaleY = slot(kHeightfield, "scale_y");

static_assert(kGridSize.max * kGridSize.max == scene::kMaxHeightVertices);

bool fits_float(double number) {
    return std::isfinite(static_cast<float>(number));
}

/// Takes what a mesh of so many vertices costs from the budget: its memory, and a step each.
bool take_grid(std::uint64_t columns, std::uint64_t rows, Span span, const HeightBuild& build) {
    return take_steps(build.budget, columns * rows, span, build.diagnostics) &&
           take_bytes(build.budget, scene::height_mesh_bytes(columns, rows), span,
                      build.diagnostics);
}

bool has_right_size(DVec2 size, Span span, Diagnostics& diagnostics) {
    const double greatest = std::max(size.x, size.y);
    if (fits_float(greatest)) return true;
    diagnostics.error(Code::E0304, span,
                      fmt::format("`size` is too large: {}", format_number(greatest)));
    return false;
}

scene::MeshUse add_mesh(const scene::HeightGrid& grid, scene::Scene& scene) {
    scene::MeshUse use;
    use.mesh_id = scene::MeshId(scene.meshes.size());
    scene.meshes.push_back(scene::make_height_mesh(grid));
    return use;
}

/// Fills a grid from the one source of heights that is set.
class HeightfieldBuilder {
 public:
    HeightfieldBuilder(const HeightProperties& properties, const HeightBuild& build)
        : properties_(properties), build_(build) {
        grid_.size = properties.values.vec2(kSize);
    }

    std::optional<scene::HeightGrid> grid() {
        const PropertyValues& values = properties_.values;
        const bool is_made = values.has(kHeight)    ? from_function()
                             : values.has(kHeights) ? from_rows()
                                                    : from_picture();
        if (!is_made) return std::nullopt;
        return std::move(grid_);
    }

 private:
    bool start(std::uint32_t columns, std::uint32_t rows, Span span) {
        if (!take_grid(columns, rows, span, build_)) return false;
        grid_.columns = columns;
        grid_.rows = rows;
        grid_.heights.reserve(std::size_t{columns} * rows);
        return true;
    }

    bool from_function() {
        const auto resolution =
            static_cast<std::uint32_t>(properties_.values.number(kResolutionSlot));
        if (!start(resolution, resolution, properties_.span_of(kResolutionSlot))) return false;
        const Span span = properties_.span_of(kHeight);
        for (std::uint32_t row = 0; row < resolution; ++row) {
            for (std::uint32_t column = 0; column < resolution; ++column) {
                const double x = grid_.x(column);
                const double z = grid_.z(row);
                const std::array arguments = {Value::of(x), Value::of(z)};
                const Value height =
                    build_.runtime.call_function(properties_.values[kHeight], arguments, span);
                if (height.is(ValueKind::poison)) return false;
                if (!height.is(ValueKind::number)) {
                    return refuse(
                        Code::E0301, span,
                        fmt::format("the height at x = {}, z = {} must be a number, this "
                                    "is {}",
                                    format_number(x), format_number(z), describe(height)));
                }
                if (!fits_float(height.number)) {
                    return refuse(
                        Code::E0304, span,
                        fmt::format("the height at x = {}, z = {} is {}: {}", format_number(x),
                                    format_number(z),
                                    std::isfinite(height.number) ? "too large" : "not finite",
                                    format_number(height.number)));
                }
                grid_.heights.push_back(height.number);
            }
        }
        return true;
    }

    bool from_rows() {
        const Value& rows = properties_.values[kHeights];
        const std::uint32_t columns = element(rows, 0).count;
        const Span span = properties_.span_of(kHeights);
        if (!is_small_enough(columns, rows.count, span)) return false;
        if (!start(columns, rows.count, span)) return false;
        for (std::uint32_t i = 0; i < rows.count; ++i) {
            const Value row = element(rows, i);
            for (std::uint32_t k = 0; k < row.count; ++k) {
                if (!fits_float(row.numbers[k])) {
                    return refuse(Code::E0304, span,
                                  fmt::format("row {} of `heights` is too large: {}", i,
                                              format_number(row.numbers[k])));
                }
                grid_.heights.push_back(row.numbers[k]);
            }
        }
        return true;
    }

    bool from_picture() {
        const Value& file = properties_.values[kImage];
        const Span span = properties_.span_of(kImage);
        const double scale = properties_.values.number(kScaleY);
        if (!fits_float(scale)) {
            return refuse(Code::E0304, properties_.span_of(kScaleY),
                          fmt::format("`scale_y` is too large: {}", format_number(scale)));
        }
        const std::optional<image::Image> picture =
            build_.files.heights(file.string(), file.source, span);
        if (!picture) return false;
        if (picture->width < 2 || picture->height < 2) {
            return refuse(Code::E0703, span,
                          fmt::format("a heightfield needs a picture of 2 x 2 pixels or more, this "
                                      "has {} x {}",
                                      picture->width, picture->height));
        }
        if (!start(picture->width, picture->height, span)) return false;
        for (std::size_t i = 0; i < picture->pixels.size(); ++i) {
            const double height = scale * luminance(DVec3{picture->pixels[i]});
            if (!fits_float(height)) {  // of a picture in floats
                return refuse(Code::E0703, span,
                              fmt::format("the height of pixel {}, {} is {}: {}",
                                          i % picture->width, i / picture->width,
                                          std::isfinite(height) ? "too large" : "not finite",
                                          format_number(height)));
            }
            grid_.heights.push_back(height);
        }
        return true;
    }

    /// Source: ITU-R BT.709-6, of linear light.
    static double luminance(DVec3 linear) {
        return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
    }

    bool is_small_enough(std::uint64_t columns, std::uint64_t rows, Span span) {
        if (columns * rows <= scene::kMaxHeightVertices) return true;
        return refuse(Code::E0304, span,
                      fmt::format("{} x {} heights are more than {}", columns, rows,
                                  scene::kMaxHeightVertices));
    }

    bool refuse(Code code, Span span, std::string message) {
        build_.diagnostics.error(code, span, std::move(message));
        return false;
    }

    const HeightProperties& properties_;
    const HeightBuild& build_;
    scene::HeightGrid grid_{};
};

}  // namespace

std::optional<scene::MeshUse> build_heightfield(const HeightProperties& properties,
                                                const HeightBuild& build) {
    const DVec2 size = properties.values.vec2(kSize);
    if (!has_right_size(size, properties.span_of(kSize), build.diagnostics)) return std::nullopt;
    const std::optional<scene::HeightGrid> grid = HeightfieldBuilder(properties, build).grid();
    if (!grid) return std::nullopt;
    return add_mesh(*grid, build.scene);
}

std::optional<scene::MeshUse> build_terrain(const HeightProperties& properties,
                                            const HeightBuild& build) {
    constexpr std::size_t kTerrainSize = slot(kTerrain, "size");
    constexpr std::size_t kTerrainHeight = slot(kTerrain, "height");
    constexpr std::size_t kTerrainResolution = slot(kTerrain, "resolution");
    const PropertyValues& values = properties.values;
    const std::string_view method =
        values.string(slot(kTerrain, "method"), kTerrainMethods.front());
    scene::TerrainSettings settings;
    settings.method = static_cast<scene::TerrainMethod>(
        std::find(kTerrainMethods.begin(), kTerrainMethods.end(), method) -
        kTerrainMethods.begin());
    settings.resolution = static_cast<std::uint32_t>(values.number(kTerrainResolution));
    settings.size = values.vec2(kTerrainSize);
    settings.height = values.number(kTerrainHeight);
    settings.roughness = values.number(slot(kTerrain, "roughness"));
    settings.random = KeyedRandom{}.with(values.number(slot(kTerrain, "seed")));

    if (!has_right_size(settings.size, properties.span_of(kTerrainSize), build.diagnostics)) {
        return std::nullopt;
    }
    if (!fits_float(settings.height)) {
        build.diagnostics.error(
            Code::E0304, properties.span_of(kTerrainHeight),
            fmt::format("`height` is too large: {}", format_number(settings.height)));
        return std::nullopt;
    }
    const Span span = properties.span_of(kTerrainResolution);
    const std::uint64_t scratch = scene::terrain_scratch_bytes(settings);
    const bool is_affordable =
        take_steps(build.budget, scene::terrain_steps(settings), span, build.diagnostics) &&
        take_bytes(build.budget, scratch, span, build.diagnostics) &&
        take_grid(settings.resolution, settings.resolution, span, build);
    if (!is_affordable) return std::nullopt;
    const scene::MeshUse use = add_mesh(scene::make_terrain(settings), build.scene);
    build.budget.value_bytes += scratch;
    return use;
}

}  // namespace lray::parser
