// The limits of microfacets: how smooth a surface of them may be, and how near to the horizon.
#pragma once

namespace lray::shade {

/// The least width of a microfacet distribution, as slope. Directions are floats: half vectors are
/// known to 2^-24, a 2^-14th of this width, so that the distribution is known to 1e-4; at its peak,
/// 1 / (pi alpha^2), it is 3.3e5. What is smoother is a mirror (`reflect`).
inline constexpr float kLeastAlpha = 0x1p-10f;

/// The least z of the sum of two directions that makes a half vector: normals cannot tell less from
/// the horizon, where quotients grow without bound.
inline constexpr float kLeastHalfZ = 0x1p-22f;

}  // namespace lray::shade
