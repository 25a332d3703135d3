#include "shade/lights/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.h"
#include "shade/lights/cone.h"
#include "shade/models/hemisphere.h"

namespace lray::shade {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

constexpr std::uint32_t kMostColumns = 1024;
constexpr std::uint32_t kMostRows = 512;

/// Source: ITU-R BT.709.
float luminance(Color color) {
    return 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b;
}

/// Returns each cell with a half of itself and a quarter of the cells beside it, along both axes:
/// pictures are looked up between their pixels, so that a bright one shines into its neighbours.
std::vector<float> smoothed(const std::vector<float>& cells, std::uint32_t width,
                            std::uint32_t height) {
    std::vector<float> along(cells.size());
    for (std::size_t row = 0; row < height; ++row) {
        const float* const from = cells.data() + row * width;
        for (std::size_t i = 0; i < width; ++i) {
            const float before = from[i == 0 ? width - 1 : i - 1];  // around the sky
            const float after = from[i + 1 == width ? 0 : i + 1];
            along[row * width + i] = 0.5f * from[i] + 0.25f * (before + after);
        }
    }
    std::vector<float> result(cells.size());
    for (std::size_t row = 0; row < height; ++row) {
        const std::size_t below = row == 0 ? row : row - 1;
        const std::size_t above = row + 1 == height ? row : row + 1;
        for (std::size_t i = 0; i < width; ++i) {
            result[row * width + i] = 0.5f * along[row * width + i] +
                                      0.25f * (along[below * width + i] + along[above * width + i]);
        }
    }
    return result;
}

/// Space: the light's.
DVec3 direction_at(double longitude, double sin_latitude) {
    const float angle = static_cast<float>((longitude - 0.5) * kTurn);
    const double cos_latitude = std::sqrt(std::max(1.0 - sin_latitude * sin_latitude, 0.0));
    return {cos_latitude * static_cast<double>(std::sin(angle)), sin_latitude,
            -cos_latitude * static_cast<double>(std::cos(angle))};
}

}  // namespace

Environment::Environment(const scene::World& world, const TextureSet& textures,
                         const scene::EnvironmentLight& light, Color color, double intensity,
                         bool is_visible)
    : textures_(textures),
      texture_id_(light.texture_id),
      scale_(light_color(color, intensity)),
      mean_(scale_),
      is_visible_(is_visible),
      light_from_world_(light.light_from_world),
      world_from_light_(glm::inverse(light.light_from_world)),
      determinant_(std::abs(glm::determinant(light.light_from_world))) {
    if (!texture_id_.is_none()) measure(world);
}

Environment::SkyPoint Environment::sky_point(DVec3 direction) const {
    DVec3 d = light_from_world_ * direction;
    const double length = glm::length(d);
    d /= length;
    const float around = std::atan2(static_cast<float>(d.x), static_cast<float>(-d.z));
    const float up =
        std::atan2(static_cast<float>(d.y), static_cast<float>(std::sqrt(d.x * d.x + d.z * d.z)));
    return {d, 0.5 + static_cast<double>(around) / kTurn,
            0.5 + static_cast<double>(up) * std::numbers::inv_pi,
            determinant_ / (length * length * length)};
}

Color Environment::texture_color(const SkyPoint& at, DVec3 direction, double width) const {
    TexturePoint point;
    point.uv = {at.longitude, std::clamp(at.latitude, pole_, 1.0 - pole_)};
    point.object = at.direction_light;
    point.world = direction;
    point.uv_width = width;
    point.object_width = width * kTurn;
    point.world_width = width * kTurn;
    return glm::clamp(scale_ * textures_.color(texture_id_, point), 0.0f,
                      static_cast<float>(kMostLight));
}

Color Environment::radiance(Vec3 direction) const {
    if (texture_id_.is_none()) return scale_;
    const DVec3 d(direction);
    return texture_color(sky_point(d), d, 0.0);
}

/// Works out how bright the texture is, cell by cell: as many as a picture has pixels, or the most.
void Environment::measure(const scene::World& world) {
    std::uint32_t width = kMostColumns;
    std::uint32_t height = kMostRows;
    const scene::Texture& texture = world.textures[texture_id_.index()];
    if (const auto* image = std::get_if<scene::ImageTexture>(&texture.pattern)) {
        const image::Pixels& pixels = world.pictures[image->picture_id.index()].pixels;
        width = std::clamp(image::width_of(pixels), 1u, kMostColumns);
        height = std::clamp(image::height_of(pixels), 1u, kMostRows);
        pole_ = 0.5 / std::max(static_cast<double>(image::height_of(pixels)), 1.0);
    }
    std::vector<float> brightness;
    brightness.reserve(std::size_t{width} * height);
    DVec3 sum{0.0};
    double brightest = 0.0;
    const double cell = std::max(1.0 / width, 0.5 / height);
    double low = -1.0;
    for (std::uint32_t row = 0; row < height; ++row) {
        const double high = -unit_circle_point(0.5 * (row + 1.0) / height).x;
        const double middle = -unit_circle_point(0.5 * (row + 0.5) / height).x;
        for (std::uint32_t column = 0; column < width; ++column) {
            SkyPoint at;
            at.longitude = (column + 0.5) / width;
            at.latitude = (row + 0.5) / height;
            at.direction_light = direction_at(at.longitude, middle);
            const DVec3 direction = glm::normalize(world_from_light_ * at.direction_light);
            const Color color = texture_color(at, direction, cell);
            brightness.push_back(luminance(color));
            brightest = std::max(brightest, double{brightness.back()});
            sum += DVec3(color) * ((high - low) / (2.0 * width));
        }
        low = high;
    }
    mean_ = Color(sum);
    if (brightest > 0.0) distribution_.emplace(width, height, smoothed(brightness, width, height));
}

std::optional<LightSample> Environment::sample(Vec3 normal, DVec2 u) const {
    LightSample s;
    double pdf = 0.0;
    if (texture_id_.is_none()) {
        const DVec3 z(normal);
        const Across frame = across(z);
        const DVec3 d(cosine_direction(u));
        s.wi = Vec3(d.x * frame.x + d.y * frame.y + d.z * z);
        pdf = d.z * std::numbers::inv_pi;
        s.irradiance = scale_ * finite_float(std::numbers::inv_pi / pdf);
    } else {
        if (!distribution_) return std::nullopt;
        const SkyDistribution::Place place = distribution_->sample(u);
        const DVec3 d =
            glm::normalize(world_from_light_ * direction_at(place.longitude, place.sin_latitude));
        s.wi = Vec3(d);
        const SkyPoint at = sky_point(d);
        pdf = place.pdf * at.solid_angle;
        s.irradiance = light_color(texture_color(at, d, 0.0), std::numbers::inv_pi / pdf);
    }
    s.irradiance = glm::min(s.irradiance, Color{static_cast<float>(kMostLight)});
    if (is_visible_) s.pdf = finite_float(pdf);
    return s;
}

float Environment::density(const Vec3& normal, const Vec3& wi) const {
    if (texture_id_.is_none()) return cosine_pdf(dot(normal, wi));
    if (!distribution_) return 0.0f;
    const SkyPoint at = sky_point(DVec3(wi));
    return finite_float(distribution_->pdf(at.longitude, at.direction_light.y) * at.solid_angle);
}

}  // namespace lray::shade
