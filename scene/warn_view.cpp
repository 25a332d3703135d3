#include "scene/warn_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "scene/placer.h"

namespace lray::scene {

namespace {

/// The picture is taken a little wider than it is, for the rounding of rays.
constexpr double kWiden = 1.001;

/// What is on the inner side has dot(normal, p) >= offset.
struct HalfSpace {
    DVec3 normal{};
    double offset = 0.0;
};

/// The view of a perspective or orthographic camera: between five planes.
class ViewVolume {
 public:
    /// Empty for a camera that has no direction.
    static std::optional<ViewVolume> make(const Camera& camera, Resolution resolution) {
        const auto forward = unit(camera.look_at - camera.position);
        const auto right = forward ? unit(cross(*forward, camera.up)) : std::nullopt;
        if (!right) return std::nullopt;
        const DVec3 up = cross(*right, *forward);
        const double aspect = static_cast<double>(resolution.width) / resolution.height;
        ViewVolume view;
        view.is_perspective_ = camera.projection == Projection::perspective;
        view.forward_ = *forward;
        view.origin_ = camera.position;
        // At distance 1 of a perspective camera, in world units of an orthographic one.
        const double y =
            kWiden * (view.is_perspective_
                          ? static_cast<double>(std::tan(static_cast<float>(camera.fov) / 2.0f))
                          : 0.5 * camera.height);
        const double x = y * aspect;
        view.add(*forward, 0.0);
        const double lean = view.is_perspective_ ? 1.0 : 0.0;
        const DVec3 lean_x = lean * x * *forward;
        const DVec3 lean_y = lean * y * *forward;
        view.add(lean_x + *right, (lean - 1.0) * x);
        view.add(lean_x - *right, (lean - 1.0) * x);
        view.add(lean_y + up, (lean - 1.0) * y);
        view.add(lean_y - up, (lean - 1.0) * y);
        view.corners_ = {x * *right + y * up, x * *right - y * up, -x * *right + y * up,
                         -x * *right - y * up};
        return view;
    }

    /// False only if the bounds are outside of the view.
    bool may_see(const Bounds& bounds) const {
        const DVec3 center = 0.5 * (DVec3{bounds.min} + DVec3{bounds.max}) - origin_;
        const DVec3 reach = 0.5 * (DVec3{bounds.max} - DVec3{bounds.min});
        for (const HalfSpace& side : sides_) {
            const DVec3 n = side.normal;
            const double extent =
                std::fabs(n.x) * reach.x + std::fabs(n.y) * reach.y + std::fabs(n.z) * reach.z;
            if (dot(n, center) + extent < side.offset) return false;
        }
        return true;
    }

    /// The rays that meet a plane are those on one side of a line in the picture: if there are
    /// any, that of a corner is among them.
    bool may_see(const Plane& plane) const {
        const DVec3 normal{plane.normal};
        const DVec3 to_plane = DVec3{plane.point} - origin_;
        return std::any_of(corners_.begin(), corners_.end(), [&](DVec3 corner) {
            const double height = dot(to_plane - (is_perspective_ ? DVec3{0.0} : corner), normal);
            const double slope = dot(forward_ + (is_perspective_ ? corner : DVec3{0.0}), normal);
            return height * slope >= 0.0;
        });
    }

 private:
    void add(DVec3 normal, double offset) { sides_[count_++] = {normal, offset}; }

    std::array<HalfSpace, 5> sides_{};  // about origin_
    std::size_t count_ = 0;
    std::array<DVec3, 4> corners_{};  // of the picture, from its middle
    DVec3 origin_{};
    DVec3 forward_{};
    bool is_perspective_ = true;
};

bool may_see(const ViewVolume& view, const AreaLight& light) {
    Bounds bounds;
    for (const DVec3 corner :
         {light.corner, light.corner + light.edge_u, light.corner + light.edge_v,
          light.corner + light.edge_u + light.edge_v}) {
        bounds.add(corner);
    }
    return view.may_see(bounds);
}

/// Of each kind so many are looked at one by one.
constexpr std::size_t kMaxEach = 10'000;

/// Bounds of all primitives of a kind where that is quick; of the others nothing is sure.
std::optional<Bounds> quick_bounds(const World& world, PrimitiveKind kind) {
    Bounds bounds;
    if (kind == PrimitiveKind::triangle) {
        for (const Vec3 vertex : world.vertices) bounds.add(vertex);
        return bounds;
    }
    if (kind == PrimitiveKind::sphere) {
        for (const Sphere& sphere : world.spheres) {
            bounds.add(sphere.center - sphere.radius);
            bounds.add(sphere.center + sphere.radius);
        }
        return bounds;
    }
    if (kind == PrimitiveKind::instance) {
        for (const WorldInstance& instance : world.instances) bounds.add(instance.bounds);
        return bounds;
    }
    return std::nullopt;
}

/// A panorama has no volume: it sees all that there is.
bool may_see_kind(const World& world, PrimitiveKind kind, const ViewVolume* view) {
    const std::vector<ObjectId>& object_ids = world.object_ids[static_cast<std::size_t>(kind)];
    for (std::size_t i = 0; i < std::min(object_ids.size(), kMaxEach); ++i) {
        if (!world.object(object_ids[i]).visible) continue;
        const PrimitiveId id(kind, i);
        const bool may_see_it =
            view == nullptr ||
            (kind == PrimitiveKind::plane ? view->may_see(world.planes[i])
                                          : view->may_see(primitive_bounds(world, id)));
        if (may_see_it) return true;
    }
    if (object_ids.size() <= kMaxEach) return false;
    const auto bounds = quick_bounds(world, kind);
    return view == nullptr || !bounds || view->may_see(*bounds);
}

bool may_see_something(const World& world, const ViewVolume* view) {
    for (const WorldLight& light : world.lights) {
        if (std::holds_alternative<EnvironmentLight>(light.light.shape)) return true;
        const auto* const area = std::get_if<AreaLight>(&light.light.shape);
        if (area != nullptr && light.visible && (view == nullptr || may_see(*view, *area))) {
            return true;
        }
    }
    for (std::size_t kind = 0; kind < kPrimitiveKindCount; ++kind) {
        if (may_see_kind(world, static_cast<PrimitiveKind>(kind), view)) return true;
    }
    return false;
}

}  // namespace

void warn_view(const Scene& scene, const World& world, std::optional<Resolution> resolution,
               Diagnostics& diagnostics) {
    const bool is_told_otherwise = world.primitive_count() == 0;  // W1503
    if (scene.cameras.empty() || scene.animation || is_told_otherwise) return;
    const Camera& camera = scene.cameras.front();
    if (camera.aperture > 0.0) return;
    std::optional<ViewVolume> view;
    if (camera.projection != Projection::panorama) {
        view = ViewVolume::make(
            camera, resolution.value_or(camera.resolution.value_or(scene.render.resolution)));
        if (!view) return;
    }
    if (may_see_something(world, view ? &*view : nullptr)) return;
    const std::string name =
        camera.name.empty() ? std::string{} : fmt::format(" `{}`", camera.name);
    const auto hides = [](const Object& object) { return !object.visible; };
    const bool is_hidden = std::all_of(world.objects.begin(), world.objects.end(), hides);
    Diagnostic& warning = diagnostics.warning(
        Code::W1205, camera.span,
        is_hidden ? fmt::format("the camera{} sees nothing: all of the scene is hidden", name)
                  : fmt::format("nothing is in view of the camera{}", name));
    if (is_hidden) {
        warning.with_help("what has `visible: false`, or is in a group that has it, is not shown");
        return;
    }
    if (world.primitive_count() > kMaxEach) return;
    const Bounds bounds = finite_bounds(world);
    if (bounds.is_empty()) return;
    const DVec3 middle = 0.5 * (DVec3{bounds.min} + DVec3{bounds.max});
    warning.with_help(
        fmt::format("the middle of the scene is at [{:.3g}, {:.3g}, {:.3g}]: "
                    "`look_at` there",
                    middle.x + 0.0, middle.y + 0.0, middle.z + 0.0));
}

}  // namespace lray::scene
