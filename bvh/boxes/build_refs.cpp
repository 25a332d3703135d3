#include "bvh/boxes/build_refs.h"

#include <cmath>

#include "base/assert.h"
#include "scene/each_primitive.h"

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

/// By how much of its extent and place the box of a curved kind is widened: two roundings to float,
/// where one would do.
constexpr double kRoundingPad = 0x1p-22;

RefClass class_of(PrimitiveKind kind) {
    switch (kind) {
        case PrimitiveKind::triangle:
        case PrimitiveKind::rectangle:
            return RefClass::triangle;
        case PrimitiveKind::sphere:
            return RefClass::sphere;
        case PrimitiveKind::ellipsoid:
            return RefClass::ellipsoid;
        case PrimitiveKind::cylinder:
            return RefClass::cylinder;
        case PrimitiveKind::disk:
            return RefClass::disk;
        case PrimitiveKind::box:
            return RefClass::box;
        case PrimitiveKind::torus:
            return RefClass::torus;
        case PrimitiveKind::instance:
            return RefClass::instance;
        case PrimitiveKind::plane:
            break;
    }
    LRAY_ASSERT(kind != PrimitiveKind::plane);
    return RefClass::triangle;
}

BuildRef make_ref(const Bounds& bounds, PrimitiveId id, std::uint32_t tag) {
    BuildRef ref;
    for (int axis = 0; axis < 3; ++axis) {
        ref.min[axis] = bounds.min[axis] + 0.0f;  // -0 + 0 is 0
        ref.max[axis] = bounds.max[axis] + 0.0f;
    }
    ref.id = id.value;
    ref.tag = tag;
    return ref;
}

Bounds bounds_of(const RefCorners& corners) {
    Bounds bounds;
    bounds.add(corners.a);
    bounds.add(corners.b);
    bounds.add(corners.c);
    return bounds;
}

Bounds widened(const Bounds& bounds) {
    const DVec3 low{bounds.min};
    const DVec3 high{bounds.max};
    const DVec3 pad = kRoundingPad * (glm::max(glm::abs(low), glm::abs(high)) + (high - low));
    Bounds result;
    result.add(low - pad);
    result.add(high + pad);
    return result;
}

}  // namespace

RefCorners corners_of(const scene::Geometry& geometry, const BuildRef& ref) {
    PrimitiveId id;
    id.value = ref.id;
    if (id.kind() == PrimitiveKind::triangle) {
        const auto& [a, b, c] = geometry.triangles[id.index()].vertices;
        return {geometry.vertices[a], geometry.vertices[b], geometry.vertices[c]};
    }
    const auto& [p00, p10, p11, p01] = geometry.rectangles[id.index()].corners;
    if ((ref.tag & BuildRef::kSecondHalf) != 0) return {p00, p11, p01};
    return {p00, p10, p11};
}

BuildRefs make_build_refs(const scene::Geometry& geometry) {
    BuildRefs result;
    result.refs.reserve(geometry.primitive_count() - geometry.planes.size() +
                        geometry.rectangles.size());
    const auto add_triangle = [&](PrimitiveId id, std::uint32_t tag) {
        BuildRef ref = make_ref({}, id, tag);
        ref = make_ref(bounds_of(corners_of(geometry, ref)), id, tag);
        result.refs.push_back(ref);
    };
    scene::each_primitive(geometry, [&](PrimitiveId id, const scene::Object& object) {
        if (!object.visible) return true;
        if (id.kind() == PrimitiveKind::plane) {
            result.planes.push_back(id);
            return true;
        }
        const auto tag = static_cast<std::uint32_t>(class_of(id.kind()));
        if (id.kind() == PrimitiveKind::triangle) {
            add_triangle(id, tag);
        } else if (id.kind() == PrimitiveKind::rectangle) {
            add_triangle(id, tag);
            add_triangle(id, tag | BuildRef::kSecondHalf);
        } else {
            const Bounds bounds = primitive_bounds(geometry, id);
            result.refs.push_back(
                make_ref(id.kind() == PrimitiveKind::instance ? bounds : widened(bounds), id, tag));
        }
        return true;
    });
    return result;
}

}  // namespace lray::bvh
