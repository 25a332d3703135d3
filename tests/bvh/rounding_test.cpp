// What the kernels take for granted of the compiler: a float is a float.
#include <gtest/gtest.h>

namespace lray::bvh {
namespace {

struct Floats {
    float x, y, z;
};
struct Doubles {
    double x, y, z;
};

Floats narrow(Doubles d) {
    return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}
Doubles widen(Floats f) {
    return {static_cast<double>(f.x), static_cast<double>(f.y), static_cast<double>(f.z)};
}

// noinline: the values must not be known while compiling.
[[gnu::noinline]] void narrow_and_widen(const Doubles& in, Floats& narrowed, Doubles& widened) {
    const Floats floats = narrow(in);
    narrowed = floats;
    widened = widen(floats);
}

// gcc 12 at -O2 and above drops both conversions for two lanes of three, unless told not to
// vectorise straight-line code (CMakeLists.txt).
TEST(Rounding, ADoubleNarrowedToFloatAndWidenedIsRounded) {
    Floats narrowed{};
    Doubles widened{};
    const volatile double third = 1.0 / 3.0;
    const Doubles in{third, third / 3.0, third / 7.0};
    narrow_and_widen(in, narrowed, widened);
    EXPECT_EQ(widened.x, static_cast<double>(narrowed.x));
    EXPECT_EQ(widened.y, static_cast<double>(narrowed.y));
    EXPECT_EQ(widened.z, static_cast<double>(narrowed.z));
}

}  // namespace
}  // namespace lray::bvh
