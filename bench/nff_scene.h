// Scenes in the Neutral File Format of Haines' Standard Procedural Databases: reading them, and
// writing the same scene for lray, POV-Ray and Tachyon.
//
// How NFF is read here, the same for all three: of `f r g b Kd Ks Shine T index` the matt colour is
// Kd times r g b; Ks is a white highlight, Phong's with the exponent Shine, and a white mirror; T
// is refraction, white too. There is no ambient light. n lights are 1/sqrt(n) each and do not
// decrease with the distance. `angle` is from edge to edge of the square picture. Source: Haines
// 1987, "A Proposal for Standard Graphics Environments".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "base/source.h"
#include "base/vec.h"
#include "bench/text_writer.h"
#include "scene/formats/nff_scene.h"

namespace lray::bench {

struct NffCamera {
    DVec3 from{0.0, 0.0, 5.0};
    DVec3 at{0.0};
    DVec3 up{0.0, 1.0, 0.0};
    double angle = 45.0;  // degrees
};

using scene::NffSurface;

struct NffSphere {
    std::uint32_t surface = 0;
    DVec3 center{0.0};
    double radius = 1.0;
};

/// Open at both ends.
struct NffCone {
    std::uint32_t surface = 0;
    DVec3 base{0.0};
    double base_radius = 1.0;
    DVec3 apex{0.0};
    double apex_radius = 1.0;
};

struct NffTriangle {
    std::uint32_t surface = 0;
    std::array<DVec3, 3> points{};
    std::optional<std::array<DVec3, 3>> normals{};
};

struct NffScene {
    DVec3 background{0.0};
    NffCamera camera{};
    std::vector<DVec3> lights{};
    std::vector<NffSurface> surfaces{};  // each different from the others
    std::vector<NffSphere> spheres{};
    std::vector<NffCone> cones{};
    std::vector<NffTriangle> triangles{};
};

/// Returns the scene. The size of the picture and the colours of lights are passed over.
/// Errors: empty, reported at the place in the file.
std::optional<NffScene> read_nff(const Sources& sources, SourceId file, Diagnostics& diagnostics);

/// Reads an OBJ as triangles of one matt surface, seen from its front upper right under one light
/// from the upper left.
/// Errors: as read_nff().
std::optional<NffScene> read_obj_scene(const Sources& sources, SourceId file,
                                       Diagnostics& diagnostics);

/// How triangles are written: each on its own, or all of a surface as one mesh, where the program
/// has meshes (Tachyon has none that keeps its faces flat).
enum class Triangles : std::uint8_t { single, mesh };

/// The levels of reflection in all three, beyond what the camera sees.
inline constexpr int kMaxReflections = 4;

void write_lrs(const NffScene& scene, Triangles triangles, TextWriter& out);

void write_pov(const NffScene& scene, Triangles triangles, TextWriter& out);

/// Errors: false for a cone of two radii, which Tachyon does not have. Refraction is written as
/// transparency: Tachyon bends no rays.
bool write_tachyon(const NffScene& scene, TextWriter& out);

}  // namespace lray::bench
