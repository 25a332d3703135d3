// Vectors and 3x3 matrices: the only place that includes GLM.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lray {

// Float: what is traced. GLM leaves members uninitialised: always write `Vec3 v{}`.
using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Mat3 = glm::mat3;

// Double: what is authored, transformed and solved.
using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
using DVec4 = glm::dvec4;
using DMat3 = glm::dmat3;

/// Linear RGB.
using Color = glm::vec3;

using glm::cross;
using glm::dot;

}  // namespace lray
