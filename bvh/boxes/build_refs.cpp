#include "bvh/boxes/build_refs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/assert.h"

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
        case PrimitiveKind::cylinder:
        case PrimitiveKind::disk:
        case PrimitiveKind::box:
        case PrimitiveKind::torus:
            return RefClass::framed;
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

Bounds widened(const Bounds& bounds) {
    const DVec3 low{bounds.min};
    const DVec3 high{bounds.max};
    const DVec3 pad = kRoundingPad * (glm::max(glm::abs(low), glm::abs(high)) + (high - low));
    Bounds result;
    result.add(low - pad);
    result.add(high + pad);
    return result;
}

/// Primitives that a task collects at least.
constexpr std::size_t kGrain = 4096;

/// Stands for what is hidden, until it is left out.
constexpr BuildRef kHidden{.id = PrimitiveId::kNone};

/// Writes one reference; of a rectangle two, one for each half.
void write_refs(const scene::Geometry& geometry, PrimitiveId id, BuildRef* refs) {
    const auto tag = static_cast<std::uint32_t>(class_of(id.kind()));
    const auto write_triangle = [&](BuildRef& ref, std::uint32_t half) {
        ref.id = id.value;
        ref.tag = tag | half;
        const RefCorners corners = corners_of(geometry, ref);
        for (int axis = 0; axis < 3; ++axis) {
            const float a = corners.a[axis];
            const float b = corners.b[axis];
            const float c = corners.c[axis];
            ref.min[axis] = std::min(std::min(a, b), c) + 0.0f;
            ref.max[axis] = std::max(std::max(a, b), c) + 0.0f;
        }
    };
    switch (id.kind()) {
        case PrimitiveKind::triangle:
            write_triangle(refs[0], 0);
            return;
        case PrimitiveKind::rectangle:
            write_triangle(refs[0], 0);
            write_triangle(refs[1], BuildRef::kSecondHalf);
            return;
        case PrimitiveKind::instance:
            refs[0] = make_ref(primitive_bounds(geometry, id), id, tag);
            return;
        case PrimitiveKind::sphere:
        case PrimitiveKind::ellipsoid:
        case PrimitiveKind::cylinder:
        case PrimitiveKind::disk:
        case PrimitiveKind::box:
        case PrimitiveKind::torus:
        case PrimitiveKind::plane:
            refs[0] = make_ref(widened(primitive_bounds(geometry, id)), id, tag);
            return;
    }
}

}  // namespace

BuildRefs make_build_refs(const scene::Geometry& geometry, double room) {
    constexpr auto kRectangle = static_cast<std::size_t>(PrimitiveKind::rectangle);
    constexpr auto kPlane = static_cast<std::size_t>(PrimitiveKind::plane);
    std::size_t count = geometry.object_ids[kRectangle].size();  // their second halves
    for (std::size_t kind = 0; kind < scene::kPrimitiveKindCount; ++kind) {
        if (kind != kPlane) count += geometry.object_ids[kind].size();
    }
    const std::size_t capacity =
        count + static_cast<std::size_t>(room * static_cast<double>(count));
    LRAY_ASSERT(capacity <= kMaxLeafFirst * std::size_t{kBoxWidth});
    BuildRefs result;
    result.arena = Arena(capacity * sizeof(BuildRef));
    result.count = static_cast<std::uint32_t>(count);
    result.capacity = static_cast<std::uint32_t>(capacity);

    const bool is_all_visible = std::ranges::all_of(geometry.objects, &scene::Object::visible);
    const auto is_visible = [&](PrimitiveId id) {
        return is_all_visible || geometry.object(geometry.object_of(id)).visible;
    };
    BuildRef* next = result.all().data();
    for (std::size_t kind = 0; kind < scene::kPrimitiveKindCount; ++kind) {
        const std::size_t kind_count = geometry.object_ids[kind].size();
        if (kind == kPlane) {
            for (std::size_t i = 0; i < kind_count; ++i) {
                const PrimitiveId id(PrimitiveKind::plane, i);
                if (is_visible(id)) result.planes.push_back(id);
            }
            continue;
        }
        const std::size_t halves = kind == kRectangle ? 2 : 1;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kind_count, kGrain),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                  const PrimitiveId id(static_cast<PrimitiveKind>(kind), i);
                                  BuildRef* const refs = next + i * halves;
                                  if (is_visible(id)) {
                                      write_refs(geometry, id, refs);
                                  } else {
                                      std::fill_n(refs, halves, kHidden);
                                  }
                              }
                          });
        next += kind_count * halves;
    }
    if (!is_all_visible) {
        const auto hidden = std::ranges::remove(result.used(), kHidden.id, &BuildRef::id);
        result.count -= static_cast<std::uint32_t>(hidden.size());
    }
    return result;
}

}  // namespace lray::bvh
