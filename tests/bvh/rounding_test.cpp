// What the kernels take for granted of the compiler: a float is a float.
#include <gtest/gtest.h>

#include "bvh/prepared_ray.h"

namespace lray::bvh {
namespace {

struct Narrowed {
    Ray ray{};
    DVec3 dir{};
};

// noinline: the values must not be known while compiling.
[[gnu::noinline]] Narrowed narrow(DVec3 dir) {
    const Ray ray{Vec3{0.0f}, Vec3{dir}};
    return {ray, prepare(ray).dir};
}

// gcc 12 at -O2 and above drops both conversions for two lanes of three, unless told not to
// vectorise straight-line code (CMakeLists.txt).
TEST(Rounding, ADoubleNarrowedToFloatAndWidenedIsRounded) {
    const Narrowed narrowed = narrow({1.0 / 3.0, 1.0 / 7.0, 1.0 / 9.0});
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(narrowed.dir[axis], static_cast<double>(narrowed.ray.dir[axis])) << axis;
    }
}

}  // namespace
}  // namespace lray::bvh
