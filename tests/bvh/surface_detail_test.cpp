// uv and tangents of every kind of shape, wherever it is placed: against finite differences, and
// against the same shape before its steps.
#include "bvh/surface_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bvh/accel.h"
#include "tests/bvh/worlds.h"
#include "tests/scene/scene_maker.h"

namespace lray::bvh {
namespace {

using scene::NodeId;
using scene::SceneMaker;
using scene::World;

TEST(SurfaceDetail, ColoursOfVerticesInProportion) {
    World world;
    world.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    world.triangles = {{{0, 1, 2}}};
    world.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::triangle)] = {
        scene::ObjectId(std::size_t{0})};
    world.objects.resize(1);
    const Hit hit{1.0f, 0.25f, 0.5f, scene::PrimitiveId(scene::PrimitiveKind::triangle, 0)};
    SurfacePoint point;
    point.normal = {0, 0, 1};
    EXPECT_EQ(surface_detail(world, hit, point).vertex_color, DVec3(1.0));
    world.colors = {{1, 0, 0}, {0, 1, 0}, {0.5f, 0, 1}};
    EXPECT_EQ(surface_detail(world, hit, point).vertex_color, DVec3(0.5, 0.25, 0.5));
}

/// A shape in its own space, all of it within 2 of the origin.
struct ShapeCase {
    std::string name{};
    std::function<NodeId(SceneMaker&, const scene::NodeSettings&)> add{};
};

void PrintTo(const ShapeCase& shape, std::ostream* out) {
    *out << shape.name;
}

template <class Shape>
ShapeCase shape_case(std::string name, Shape shape) {
    return {std::move(name), [shape](SceneMaker& maker, const scene::NodeSettings& settings) {
                return maker.add(shape, settings);
            }};
}

ShapeCase triangle_case(std::string name, const scene::TriangleAttributes& attributes) {
    return {std::move(name), [attributes](SceneMaker& maker, const scene::NodeSettings& settings) {
                scene::TriangleShape shape{{-1, -1, 0.2}, {1.2, -0.8, 0}, {0.1, 1.3, -0.3}};
                if (attributes.uvs || attributes.normals) {
                    shape.attributes =
                        static_cast<std::uint32_t>(maker.scene.triangle_attributes.size());
                    maker.scene.triangle_attributes.push_back(attributes);
                }
                return maker.add(shape, settings);
            }};
}

std::vector<ShapeCase> shape_cases() {
    const std::array<DVec2, 3> uvs{DVec2{0.1, 0.2}, DVec2{0.9, 0.4}, DVec2{0.3, 1.5}};
    const std::array<DVec3, 3> normals{DVec3{-0.3, -0.2, 1}, DVec3{0.4, 0, 1}, DVec3{0, 0.5, 1}};
    return {
        triangle_case("triangle", {}),
        triangle_case("triangle_with_uvs", {{}, uvs}),
        triangle_case("triangle_with_normals", {normals, {}}),
        triangle_case("triangle_with_both", {normals, uvs}),
        shape_case("rectangle", scene::RectangleShape{{-1, -0.5, 0.5}, {2, 0.3, 0}, {0, 1, -1}}),
        shape_case("sphere", scene::SphereShape{{0.2, -0.1, 0.3}, 1.3}),
        shape_case("cylinder", scene::CylinderShape{{0.1, -1, 0}, {0.3, 1, 0.4}, 0.6, 0.6}),
        shape_case("cone", scene::CylinderShape{{0.1, -1, 0}, {0.3, 1, 0.4}, 1.1, 0.0}),
        shape_case("cup", scene::CylinderShape{{0.1, -1, 0}, {0.3, 1, 0.4}, 0.4, 1.1}),
        shape_case("disk", scene::DiskShape{{0, 0.2, 0}, {0.2, 1, 0.5}, 1.2, 0.1}),
        shape_case("box", scene::BoxShape{{-1, -0.7, -0.4}, {0.9, 0.8, 0.6}}),
        shape_case("plane", scene::PlaneShape{{0, 0.2, 0.1}, DVec3{0.6, 0.0, -0.8}}),
        shape_case("torus", scene::TorusShape{0.9, 0.4}),
    };
}

struct Seen {
    Ray ray{};
    Hit hit{};
    SurfacePoint point{};
    SurfaceDetail detail{};
};

/// A world and what looks at it.
class View {
 public:
    explicit View(World world)
        : world_(std::move(world)), accel_(build(world_, {.kind = AccelKind::none})) {}

    const World& world() const { return world_; }

    std::optional<Seen> look(const Ray& ray, Interval interval = {}) const {
        TraceCounts counts;
        Seen seen{ray, accel_->nearest_hit(ray, interval, counts), {}, {}};
        if (seen.hit.is_none()) return std::nullopt;
        seen.point = surface_at(world_, ray, seen.hit);
        seen.detail = surface_detail(world_, seen.hit, seen.point);
        return seen;
    }

 private:
    World world_;
    std::unique_ptr<Accel> accel_;
};

Ray ray_between(DVec3 from, DVec3 to) {
    return {Vec3{from}, Vec3{glm::normalize(to - from)}};
}

scene::MaterialId add_textured(SceneMaker& maker) {
    const scene::MaterialId id = maker.add_material(Color{0.5f});
    maker.scene.textures.emplace_back();
    maker.scene.materials[id.index()].diffuse.texture_id =
        scene::TextureId{maker.scene.textures.size() - 1};
    return id;
}

View view_of(const ShapeCase& shape, const Transform& steps) {
    SceneMaker maker;
    maker.place(shape.add(maker, {.transform = steps, .material = add_textured(maker)}));
    return View(maker.flatten_cleanly());
}

/// The shape twice within instances within instances; `steps` is all that the second one is moved
/// by, which shows its texture through inheritance.
View view_in_instances(const ShapeCase& shape, const Transform& own, const Transform& inner,
                       const Transform& outer) {
    SceneMaker maker;
    const Transform away = Transform::translation({1000, 0, 0});
    const NodeId node = shape.add(maker, {.transform = own});
    const NodeId pair = maker.add_group({node, maker.add(scene::SphereShape{{300, 0, 0}, 0.1})});
    const NodeId pairs = maker.add_group({maker.add_instance(pair, {.transform = away}),
                                          maker.add_instance(pair, {.transform = inner})});
    maker.place(maker.add_instance(pairs, {.transform = away.then(away)}));
    maker.place(maker.add_instance(pairs, {.transform = outer, .material = add_textured(maker)}));
    Diagnostics diagnostics;
    scene::FlattenLimits limits;
    limits.sharing = {1, 1};
    auto world = flatten(maker.scene, limits, diagnostics);
    EXPECT_TRUE(world.has_value());
    return View(world ? std::move(*world) : World{});
}

/// Any affine map that does not flatten much; mirrored about every second time.
Transform random_transform(Random& random) {
    DVec3 factors{};
    for (int axis = 0; axis < 3; ++axis) {
        factors[axis] = static_cast<double>(random.uniform(0.5f, 1.6f));
    }
    if (random.below(2) == 0) factors[random.below(3)] *= -1.0;
    return Transform::affine(random.rotation(), DVec3{0.0})
        .then(Transform::scaling(factors))
        .then(Transform::affine(random.rotation(), DVec3{random.in_cube(5.0f)}));
}

Transform random_similarity(Random& random) {
    const DMat3 turn = random.rotation();
    return Transform::rotation(turn[0], static_cast<double>(random.uniform(0, 360)))
        .then(Transform::scaling(static_cast<double>(random.below(2) == 0 ? 0.7f : -1.4f)))
        .then(Transform::translation(DVec3{random.in_cube(5.0f)}));
}

Ray random_ray_at(Random& random, const Transform& world_from_shape) {
    const DVec3 from = world_from_shape.point(DVec3{6.0f * random.direction()});
    return ray_between(from, world_from_shape.point(DVec3{random.in_cube(0.9f)}));
}

/// The difference of two uv, angles taken the short way: they begin anew after 1.
DVec2 difference(DVec2 a, DVec2 b, bool is_periodic) {
    DVec2 d = a - b;
    if (is_periodic) d -= glm::round(d);
    return d;
}

bool is_periodic(const Seen& seen) {
    const scene::PrimitiveKind kind = seen.hit.primitive_id.kind();
    return kind == scene::PrimitiveKind::sphere || kind == scene::PrimitiveKind::ellipsoid ||
           kind == scene::PrimitiveKind::torus ||
           (kind == scene::PrimitiveKind::cylinder && seen.hit.u == 0.0f);
}

bool is_on_same_side(const Seen& a, const Seen& b) {
    const scene::PrimitiveKind kind = a.hit.primitive_id.kind();
    const bool has_parts =
        kind == scene::PrimitiveKind::cylinder || kind == scene::PrimitiveKind::box;
    return a.hit.primitive_id == b.hit.primitive_id && (!has_parts || a.hit.u == b.hit.u);
}

/// Moves along a tangent, looks down on the surface there, and returns how uv changed per step.
std::optional<DVec2> measured_change(const View& view, const Seen& seen, DVec3 tangent) {
    const double h = 0.004 / glm::length(tangent);
    const DVec3 normal{seen.detail.shading_normal};
    std::array<std::optional<Seen>, 2> ends{};
    for (std::size_t i = 0; i < 2; ++i) {
        const DVec3 aside = DVec3{seen.point.position} + (i == 0 ? h : -h) * tangent;
        ends[i] = view.look({Vec3{aside + 0.05 * normal}, Vec3{-normal}}, {0.0f, 0.1f});
        if (!ends[i] || !is_on_same_side(seen, *ends[i])) return std::nullopt;
    }
    return difference(ends[0]->detail.uv, ends[1]->detail.uv, is_periodic(seen)) / (2.0 * h);
}

/// Returns how many places were compared.
int expect_tangents_as_measured(const View& view, Random& random, const Transform& map) {
    int checked = 0;
    for (int i = 0; i < 40; ++i) {
        const auto seen = view.look(random_ray_at(random, map));
        if (!seen) continue;
        const SurfaceDetail& detail = seen->detail;
        const DVec3 du{detail.dp_du};
        const DVec3 dv{detail.dp_dv};
        EXPECT_NEAR(dot(glm::normalize(du), DVec3{detail.shading_normal}), 0.0, 1e-5);
        EXPECT_NEAR(dot(glm::normalize(dv), DVec3{detail.shading_normal}), 0.0, 1e-5);
        // Beside a pole a step is no longer small.
        if (glm::length(du) < 0.3 || glm::length(dv) < 0.3) continue;
        const auto along_u = measured_change(view, *seen, du);
        const auto along_v = measured_change(view, *seen, dv);
        if (!along_u || !along_v) continue;  // across an edge
        ++checked;
        EXPECT_NEAR(along_u->x, 1.0, 0.01);
        EXPECT_NEAR(along_u->y, 0.0, 0.01);
        EXPECT_NEAR(along_v->x, 0.0, 0.01);
        EXPECT_NEAR(along_v->y, 1.0, 0.01);
    }
    return checked;
}

class DetailOfShape : public testing::TestWithParam<ShapeCase> {};

TEST_P(DetailOfShape, TangentsAreThoseOfFiniteDifferences) {
    constexpr std::uint64_t kSeed = 41;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    Random random(kSeed);
    int checked = 0;
    for (int i = 0; i < 12; ++i) {
        const Transform steps = i % 2 == 0 ? random_transform(random) : random_similarity(random);
        checked += expect_tangents_as_measured(view_of(GetParam(), steps), random, steps);
    }
    EXPECT_GT(checked, 60);
}

TEST_P(DetailOfShape, TangentsInInstancesAreThoseOfFiniteDifferences) {
    if (GetParam().name == "plane") return;  // never shared
    constexpr std::uint64_t kSeed = 42;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    Random random(kSeed);
    int checked = 0;
    for (int i = 0; i < 8; ++i) {
        const Transform own = random_similarity(random);
        const Transform inner = i % 2 == 0 ? random_transform(random) : random_similarity(random);
        const Transform outer = random_similarity(random);
        const View view = view_in_instances(GetParam(), own, inner, outer);
        ASSERT_EQ(view.world().prototypes.size(), 2u);
        checked += expect_tangents_as_measured(view, random, own.then(inner).then(outer));
    }
    EXPECT_GT(checked, 40);
}

/// The shape as it is and where it was moved to, seen by the same ray, moved likewise.
void expect_moved_along(const View& own, const View& placed, const Transform& map, Random& random,
                        const std::string& name) {
    const DMat3 inverse = glm::inverse(map.linear());
    int checked = 0;
    for (int i = 0; i < 40; ++i) {
        const Ray ray = random_ray_at(random, Transform{});
        const auto before = own.look(ray);
        if (!before || before->hit.t > 10.0f) continue;  // far out on a plane
        const DVec3 from = map.point(DVec3{ray.origin});
        const auto after = placed.look(ray_between(from, map.point(DVec3{before->point.position})));
        if (!after || !is_on_same_side(*before, *after)) {
            // A sphere under a map that is no similarity is an ellipsoid.
            if (!after || name != "sphere") continue;
        }
        ++checked;
        const DVec2 off = difference(before->detail.uv, after->detail.uv, is_periodic(*before));
        EXPECT_NEAR(glm::length(off), 0.0, 1e-4) << name;
        EXPECT_LE(glm::length(after->detail.position_object - DVec3{before->point.position}), 3e-5);
        for (int axis = 0; axis < 3; ++axis) {
            const DVec3 column = after->detail.object_from_world[axis];
            EXPECT_LE(glm::length(column - inverse[axis]), 1e-5);
        }
        const double mean = std::sqrt((dot(inverse[0], inverse[0]) + dot(inverse[1], inverse[1]) +
                                       dot(inverse[2], inverse[2])) /
                                      3.0);
        EXPECT_NEAR(after->detail.object_per_world, mean, 1e-5 * mean);
        // Normals of corners are not at right angles to what was: only their side is the same.
        EXPECT_GT(dot(after->detail.shading_normal, after->point.normal), 0.0f);
        if (name.find("normals") != std::string::npos || name.find("both") != std::string::npos) {
            const DVec3 turned = glm::normalize(DVec3{before->detail.shading_normal} * inverse);
            // Those of the corners are made unit first, which is the same where lengths are kept.
            EXPECT_LE(glm::length(turned - DVec3{after->detail.shading_normal}),
                      map.is_similarity() ? 1e-4 : 0.2);
            continue;
        }
        const DVec3 du = map.vector(DVec3{before->detail.dp_du});
        const DVec3 dv = map.vector(DVec3{before->detail.dp_dv});
        EXPECT_LE(glm::length(du - DVec3{after->detail.dp_du}), 1e-3 * (glm::length(du) + 0.1));
        EXPECT_LE(glm::length(dv - DVec3{after->detail.dp_dv}), 1e-3 * (glm::length(dv) + 0.1));
    }
    EXPECT_GT(checked, 2) << name;
}

TEST_P(DetailOfShape, TextureMovesWithTheShape) {
    constexpr std::uint64_t kSeed = 43;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    Random random(kSeed);
    const View own = view_of(GetParam(), Transform{});
    for (int i = 0; i < 12; ++i) {
        const Transform steps = i % 2 == 0 ? random_transform(random) : random_similarity(random);
        expect_moved_along(own, view_of(GetParam(), steps), steps, random, GetParam().name);
    }
}

TEST_P(DetailOfShape, TextureMovesWithTheInstances) {
    if (GetParam().name == "plane") return;
    constexpr std::uint64_t kSeed = 44;
    SCOPED_TRACE(testing::Message() << "seed " << kSeed);
    Random random(kSeed);
    const View own = view_of(GetParam(), Transform{});
    for (int i = 0; i < 8; ++i) {
        const Transform step = i % 2 == 0 ? random_transform(random) : random_similarity(random);
        const Transform inner = random_similarity(random);
        const Transform outer = random_similarity(random);
        expect_moved_along(own, view_in_instances(GetParam(), step, inner, outer),
                           step.then(inner).then(outer), random, GetParam().name);
    }
}

INSTANTIATE_TEST_SUITE_P(AllShapes, DetailOfShape, testing::ValuesIn(shape_cases()),
                         [](const auto& shape) { return shape.param.name; });

template <class Shape>
SurfaceDetail detail_of(const Shape& shape, DVec3 from, DVec3 to) {
    const View view = view_of(shape_case("", shape), Transform{});
    const auto seen = view.look(ray_between(from, to));
    EXPECT_TRUE(seen.has_value());
    return seen ? seen->detail : SurfaceDetail{};
}

void expect_uv(DVec2 found, double u, double v) {
    EXPECT_NEAR(found.x, u, 1e-6);
    EXPECT_NEAR(found.y, v, 1e-6);
}

TEST(SurfaceUv, OfASphereHasItsMiddleInFrontAndRunsToTheRight) {
    const scene::SphereShape ball{};
    const DVec3 middle{0.0};
    expect_uv(detail_of(ball, {0, 0, 5}, middle).uv, 0.5, 0.5);
    expect_uv(detail_of(ball, {5, 0, 0}, middle).uv, 0.75, 0.5);
    expect_uv(detail_of(ball, {-5, 0, 0}, middle).uv, 0.25, 0.5);
    expect_uv(detail_of(ball, {0, 5, 5}, middle).uv, 0.5, 0.75);
    expect_uv(detail_of(ball, {0, -5, 5}, middle).uv, 0.5, 0.25);
    const SurfaceDetail front = detail_of(ball, {0, 0, 5}, middle);
    EXPECT_NEAR(front.dp_du.x, 6.2831853f, 1e-5f);
    EXPECT_NEAR(front.dp_dv.y, 3.1415927f, 1e-5f);
}

TEST(SurfaceUv, OfASphereBeginsAnewBehindIt) {
    const scene::SphereShape ball{};
    EXPECT_NEAR(detail_of(ball, {-0.01, 0, -5}, {-0.01, 0, 0}).uv.x, 0.0, 0.002);
    EXPECT_NEAR(detail_of(ball, {0.01, 0, -5}, {0.01, 0, 0}).uv.x, 1.0, 0.002);
}

TEST(SurfaceUv, AtAPoleNothingHasADirectionAndAllIsFinite) {
    for (const double side : {1.0, -1.0}) {
        const SurfaceDetail pole = detail_of(scene::SphereShape{}, {0, 5 * side, 0}, {0, 0, 0});
        EXPECT_EQ(pole.uv.y, side > 0 ? 1.0 : 0.0);
        EXPECT_EQ(pole.dp_du, Vec3{0.0f});
        EXPECT_EQ(pole.dp_dv, Vec3{0.0f});
    }
    const scene::CylinderShape cone{{0, 0, 0}, {0, 1, 0}, 1.0, 0.0};
    const SurfaceDetail tip = detail_of(cone, {0, 5, 0}, {0, 0, 0});
    EXPECT_NEAR(tip.uv.y, 1.0, 1e-6);
    EXPECT_TRUE(std::isfinite(tip.uv.x) && std::isfinite(tip.dp_du.x) &&
                std::isfinite(tip.dp_dv.y));
    const SurfaceDetail apple = detail_of(scene::TorusShape{0.2, 0.4}, {0, 5, 0}, {0, 0, 0});
    EXPECT_TRUE(std::isfinite(apple.uv.y) && std::isfinite(apple.dp_dv.y));
}

TEST(SurfaceUv, OfACylinderRunsFromItsBeginning) {
    const scene::CylinderShape cone{{0, 0, 0}, {0, 2, 0}, 1.0, 0.5};
    expect_uv(detail_of(cone, {0, 0.5, 5}, {0, 0.5, 0}).uv, 0.5, 0.25);
    const scene::CylinderShape cup{{0, 0, 0}, {0, 2, 0}, 0.5, 1.0};
    expect_uv(detail_of(cup, {0, 0.5, 5}, {0, 0.5, 0}).uv, 0.5, 0.25);
    expect_uv(detail_of(cup, {5, 0.5, 0}, {0, 0.5, 0}).uv, 0.75, 0.25);
    // Its ends, as wide as they are.
    expect_uv(detail_of(cup, {0.5, 5, 0}, {0.5, 0, 0}).uv, 0.75, 0.5);
    expect_uv(detail_of(cup, {0.25, -5, 0}, {0.25, 0, 0}).uv, 0.75, 0.5);
    expect_uv(detail_of(cup, {0, 5, -0.5}, {0, 0, -0.5}).uv, 0.5, 0.75);
    expect_uv(detail_of(cup, {0, -5, 0.25}, {0, 0, 0.25}).uv, 0.5, 0.75);
}

TEST(SurfaceUv, OfFlatShapesIsThatOfAPictureOnThem) {
    expect_uv(detail_of(scene::RectangleShape{}, {0.25, 5, 0.5}, {0.25, 0, 0.4}).uv, 0.75, 0.1);
    expect_uv(detail_of(scene::DiskShape{}, {0.5, 5, 0.25}, {0.5, 0, 0.25}).uv, 0.75, 0.375);
    expect_uv(detail_of(scene::PlaneShape{{1, 0, 0}}, {3.5, 5, 2}, {3.5, 0, 2}).uv, 2.5, -2.0);
    // A wall's u runs along +X and its v up.
    const scene::PlaneShape wall{{0, 0, 0}, {0, 0, 1}};
    expect_uv(detail_of(wall, {2, 3, 5}, {2, 3, 0}).uv, 2.0, 3.0);
}

TEST(SurfaceUv, OfABoxIsUprightOnEachSide) {
    const scene::BoxShape box{DVec3{-1}, DVec3{1}};
    expect_uv(detail_of(box, {0.5, 0.2, 5}, {0.5, 0.2, 0}).uv, 0.75, 0.6);
    expect_uv(detail_of(box, {0.5, 0.2, -5}, {0.5, 0.2, 0}).uv, 0.25, 0.6);
    expect_uv(detail_of(box, {5, 0.2, 0.5}, {0, 0.2, 0.5}).uv, 0.25, 0.6);
    expect_uv(detail_of(box, {-5, 0.2, 0.5}, {0, 0.2, 0.5}).uv, 0.75, 0.6);
    expect_uv(detail_of(box, {0.5, 5, 0.2}, {0.5, 0, 0.2}).uv, 0.75, 0.4);
    expect_uv(detail_of(box, {0.5, -5, 0.2}, {0.5, 0, 0.2}).uv, 0.75, 0.6);
}

TEST(SurfaceUv, OfATorusIsBothAngles) {
    const scene::TorusShape ring{1.0, 0.25};
    expect_uv(detail_of(ring, {0, 0, 5}, {0, 0, 0}).uv, 0.5, 0.5);
    expect_uv(detail_of(ring, {1, 5, 0}, {1, 0, 0}).uv, 0.75, 0.75);
    expect_uv(detail_of(ring, {1, -5, 0}, {1, 0, 0}).uv, 0.75, 0.25);
}

TEST(SurfaceUv, OfATriangleWithoutCoordinatesIsItsShares) {
    const scene::TriangleShape shape{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    expect_uv(detail_of(shape, {0.5, 0.25, 5}, {0.5, 0.25, 0}).uv, 0.5, 0.25);
}

TEST(SurfaceUv, DegenerateCoordinatesHaveNoDirection) {
    const std::array<DVec2, 3> one_point{DVec2{0.5}, DVec2{0.5}, DVec2{0.5}};
    const std::array<DVec2, 3> on_a_line{DVec2{0, 0}, DVec2{1, 1}, DVec2{2, 2}};
    for (const auto& uvs : {one_point, on_a_line}) {
        const View view = view_of(triangle_case("", {{}, uvs}), Transform{});
        const auto seen = view.look({{0, 0, 5}, {0, 0, -1}});
        ASSERT_TRUE(seen.has_value());
        EXPECT_EQ(seen->detail.dp_du, Vec3{0.0f});
        EXPECT_EQ(seen->detail.dp_dv, Vec3{0.0f});
        EXPECT_TRUE(std::isfinite(seen->detail.uv.x));
    }
}

TEST(ShadingNormal, IsBetweenTheNormalsOfTheCornersOnTheSideOfTheSurface) {
    for (const double side : {1.0, -1.0}) {
        // Turned around, they are taken back to the front.
        const std::array<DVec3, 3> normals{side * DVec3{-1, 0, 1}, side * DVec3{1, 0, 1},
                                           side * DVec3{0, 1, 1}};
        SceneMaker maker;
        scene::TriangleShape shape{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0};
        maker.scene.triangle_attributes.push_back({normals, {}});
        maker.place(maker.add(shape));
        const View view(maker.flatten_cleanly());
        const auto seen = view.look({{0, 0.001f, 5}, {0, 0, -1}});
        ASSERT_TRUE(seen.has_value());
        EXPECT_NEAR(seen->detail.shading_normal.x, 0.0f, 1e-3f);
        EXPECT_NEAR(seen->detail.shading_normal.z, 1.0f, 1e-3f);
        EXPECT_EQ(shading_normal(view.world(), seen->hit, seen->point),
                  seen->detail.shading_normal);
        EXPECT_EQ(seen->point.normal, (Vec3{0, 0, 1}));
    }
}

TEST(ShadingNormal, OfOppositeNormalsIsTheSurfaces) {
    SceneMaker maker;
    scene::TriangleShape shape{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}, 0};
    maker.scene.triangle_attributes.push_back(
        {std::array<DVec3, 3>{DVec3{1, 0, 0}, DVec3{-1, 0, 0}, DVec3{1, 0, 0}}, {}});
    maker.place(maker.add(shape));
    const View view(maker.flatten_cleanly());
    const auto seen = view.look({{0.5f, -0.5f, 5}, {0, 0, -1}});
    ASSERT_TRUE(seen.has_value());
    const Vec3 normal = seen->detail.shading_normal;
    EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace lray::bvh
