#include "tests/parser/same_world.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>
#include <optional>
#include <variant>

#include "scene/flatten.h"

namespace lray::test {

namespace {

/// Writes numbers by their bits: -0 is not 0.
class BitWriter {
 public:
    void add(float x) { put(std::bit_cast<std::uint32_t>(x)); }
    void add(double x) { put(std::bit_cast<std::uint64_t>(x)); }
    void add(bool x) { put(x ? 1 : 0); }
    void add(std::uint32_t x) { put(x); }
    void add(Vec2 v) { add_all(v.x, v.y); }
    void add(DVec2 v) { add_all(v.x, v.y); }
    void add(Vec3 v) { add_all(v.x, v.y, v.z); }
    void add(DVec3 v) { add_all(v.x, v.y, v.z); }
    void add(const Mat3& m) { add_all(m[0], m[1], m[2]); }
    void add(const DMat3& m) { add_all(m[0], m[1], m[2]); }
    void add(const scene::IndexTriple& t) { add_all(t[0], t[1], t[2]); }
    void add(const scene::AffineFrame& f) { add_all(f.origin, f.object_from_world); }
    void add(const scene::Triangle& t) { add(t.vertices); }
    void add(const scene::Rectangle& r) {
        for (const Vec3 corner : r.corners) add(corner);
        add(r.is_mirrored);
    }
    void add(const scene::Sphere& s) { add_all(s.center, s.radius); }
    void add(const scene::Ellipsoid& e) { add(e.frame); }
    void add(const scene::Cylinder& c) { add_all(c.frame, c.top_radius, c.caps); }
    void add(const scene::Disk& d) { add_all(d.frame, d.hole); }
    void add(const scene::Box& b) { add(b.frame); }
    void add(const scene::Plane& p) { add_all(p.point, p.normal); }
    void add(const scene::Torus& t) { add_all(t.frame, t.tube); }
    void add(const scene::ColorStop& s) { add_all(s.at, s.color); }
    void add(const Transform& t) { add_all(t.linear(), t.offset(), t.is_similarity()); }

    template <class T>
    void add(const std::vector<T>& all) {
        text_ += fmt::format("\n{}:", all.size());
        for (const T& one : all) add(one);
    }
    template <class... All>
    void add_all(const All&... all) {
        (add(all), ...);
    }

    std::string take() { return std::move(text_); }

 private:
    void put(std::uint64_t bits) { fmt::format_to(std::back_inserter(text_), "{:x} ", bits); }
    std::string text_;
};

class WorldWriter {
 public:
    WorldWriter(const scene::Scene& scene, const scene::World& world)
        : scene_(scene), world_(world) {}

    std::string text() {
        out_.add_all(world_.vertices, world_.triangles, world_.rectangles, world_.spheres,
                     world_.ellipsoids, world_.cylinders, world_.disks, world_.boxes, world_.planes,
                     world_.tori, world_.normals, world_.uvs, world_.triangle_normals,
                     world_.triangle_uvs, world_.colors, world_.mean_colors);
        for (const auto& ids : world_.object_ids) {
            for (const scene::ObjectId id : ids) add_object(world_.object(id));
        }
        for (const scene::WorldLight& light : world_.lights) add_light(light);
        return out_.take();
    }

 private:
    void add_object(const scene::Object& object) {
        out_.add_all(object.visible, object.casts_shadow);
        add_material(world_.materials[object.material]);
    }
    template <class T>
    void add_coefficient(const scene::CoefficientOf<T>& coefficient) {
        out_.add(coefficient.constant);
        add_texture(coefficient.texture_id);
    }
    void add_material(const scene::Material& m) {
        out_.add_all(static_cast<std::uint32_t>(m.model), m.ior, m.two_sided, m.ambient.has_value(),
                     m.specular.has_value());
        add_coefficient(m.ambient.value_or(scene::Coefficient{}));
        add_coefficient(m.specular.value_or(scene::Coefficient{}));
        for (const auto& c :
             {m.diffuse, m.fresnel, m.reflect, m.transmit, m.absorption, m.emission}) {
            add_coefficient(c);
        }
        add_coefficient(m.shininess);
        add_coefficient(m.opacity);
        add_coefficient(m.roughness);
        add_texture(m.bump_id);
        out_.add_all(m.bump_height, static_cast<std::uint32_t>(m.bump_unit));
        add_texture(m.normal_map_id);
    }
    void add_texture(scene::TextureId id) {
        out_.add(id.is_none());
        if (id.is_none()) return;
        const scene::Texture& texture = world_.textures[id.index()];
        out_.add_all(static_cast<std::uint32_t>(texture.space), texture.texture_from_space,
                     texture.average, static_cast<std::uint32_t>(texture.pattern.index()));
        std::visit([this](const auto& pattern) { add_pattern(pattern); }, texture.pattern);
    }
    void add_pattern(const scene::ImageTexture& t) {
        const scene::Picture& picture = scene_.pictures[t.picture_id.index()];
        out_.add_all(static_cast<std::uint32_t>(t.wrap), static_cast<std::uint32_t>(t.filter),
                     t.is_srgb, picture.srgb_mean, image::width_of(picture.pixels));
    }
    void add_pattern(const scene::CheckerTexture& t) { out_.add_all(t.a, t.b, t.size); }
    void add_pattern(const scene::StripesTexture& t) {
        out_.add_all(t.a, t.b, t.size, static_cast<std::uint32_t>(t.axis));
    }
    void add_pattern(const scene::GradientTexture& t) {
        out_.add_all(static_cast<std::uint32_t>(t.axis), t.stops);
    }
    void add_pattern(const scene::RampTexture& t) {
        out_.add_all(static_cast<std::uint32_t>(t.axis), t.stops);
    }
    void add_pattern(const scene::NoiseTexture& t) {
        out_.add_all(t.octaves, t.lacunarity, t.gain, t.seed, t.stops);
    }
    void add_pattern(const scene::VertexColorsTexture&) {}
    template <class Veined>
    void add_pattern(const Veined& t) {
        out_.add_all(t.a, t.b, t.size, t.turbulence, t.octaves, static_cast<std::uint32_t>(t.axis),
                     t.seed);
    }
    void add_light(const scene::WorldLight& light) {
        out_.add_all(light.light.color, light.light.intensity, light.visible, light.casts_shadow,
                     static_cast<std::uint32_t>(light.light.shape.index()));
        if (const auto* point = std::get_if<scene::PointLight>(&light.light.shape)) {
            out_.add_all(point->position, point->radius, point->samples,
                         static_cast<std::uint32_t>(point->falloff));
        } else if (const auto* spot = std::get_if<scene::SpotLight>(&light.light.shape)) {
            out_.add_all(spot->position, spot->direction, spot->angle, spot->softness, spot->radius,
                         spot->samples, static_cast<std::uint32_t>(spot->falloff));
        } else if (const auto* sun = std::get_if<scene::DirectionalLight>(&light.light.shape)) {
            out_.add_all(sun->direction, sun->angle, sun->samples);
        } else if (const auto* area = std::get_if<scene::AreaLight>(&light.light.shape)) {
            out_.add_all(area->corner, area->edge_u, area->edge_v, area->samples);
        } else {
            const auto& sky = std::get<scene::EnvironmentLight>(light.light.shape);
            out_.add_all(sky.light_from_world, sky.samples);
            add_texture(sky.texture_id);
        }
    }

    const scene::Scene& scene_;
    const scene::World& world_;
    BitWriter out_;
};

}  // namespace

std::string world_text(const scene::Scene& scene) {
    Diagnostics diagnostics;
    const std::optional<scene::World> world = scene::flatten(scene, {}, diagnostics);
    return world ? WorldWriter(scene, *world).text() : std::string();
}

}  // namespace lray::test
