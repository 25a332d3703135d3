// Writing: the same scene for lray, POV-Ray and Tachyon, each in what its manual has for it.
#include "bench/nff_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace lray::bench {

/// Blanks between the numbers, as Tachyon wants them.
struct Spaced {
    DVec3 v{};
};

/// A point or direction for Tachyon, whose space is left-handed.
struct Mirrored {
    DVec3 v{};
};

}  // namespace lray::bench

/// Numbers as they were read: the shortest that give the same double.
template <>
struct fmt::formatter<lray::DVec3> : fmt::formatter<std::string_view> {
    auto format(const lray::DVec3& v, fmt::format_context& context) const {
        return fmt::format_to(context.out(), "{}, {}, {}", v.x, v.y, v.z);
    }
};

template <>
struct fmt::formatter<lray::bench::Spaced> : fmt::formatter<std::string_view> {
    auto format(const lray::bench::Spaced& s, fmt::format_context& context) const {
        return fmt::format_to(context.out(), "{} {} {}", s.v.x, s.v.y, s.v.z);
    }
};

template <>
struct fmt::formatter<lray::bench::Mirrored> : fmt::formatter<std::string_view> {
    auto format(const lray::bench::Mirrored& m, fmt::format_context& context) const {
        return fmt::format_to(context.out(), "{} {} {}", m.v.x, m.v.y, -m.v.z);
    }
};

namespace lray::bench {

namespace {

constexpr double kMaxShininess = 10'000.0;  // of lray

/// Unit vectors of the picture and half its side at the distance 1.
struct View {
    DVec3 forward{};
    DVec3 right{};
    DVec3 up{};
    double half_side = 1.0;
};

View view_of(const NffCamera& camera) {
    View view;
    view.forward = glm::normalize(camera.at - camera.from);
    view.right = glm::normalize(cross(view.forward, camera.up));
    view.up = cross(view.right, view.forward);
    view.half_side = std::tan(camera.angle * std::numbers::pi / 360.0);
    return view;
}

double light_strength(const NffScene& scene) {
    return 1.0 / std::sqrt(static_cast<double>(std::max<std::size_t>(1, scene.lights.size())));
}

std::vector<const NffTriangle*> triangles_of(const NffScene& scene, std::uint32_t surface) {
    std::vector<const NffTriangle*> found;
    for (const NffTriangle& triangle : scene.triangles) {
        if (triangle.surface == surface) found.push_back(&triangle);
    }
    return found;
}

/// Corners of triangles, equal ones once, and three indices for each triangle.
struct Indexed {
    std::vector<DVec3> points{};
    std::vector<std::array<std::size_t, 3>> triangles{};
};

Indexed index_points(const std::vector<const NffTriangle*>& triangles) {
    const auto is_less = [](const DVec3& a, const DVec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    Indexed indexed;
    for (const NffTriangle* triangle : triangles) {
        indexed.points.insert(indexed.points.end(), triangle->points.begin(),
                              triangle->points.end());
    }
    std::vector<DVec3>& points = indexed.points;
    std::sort(points.begin(), points.end(), is_less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const NffTriangle* triangle : triangles) {
        std::array<std::size_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto found =
                std::lower_bound(points.begin(), points.end(), triangle->points[i], is_less);
            corners[i] = static_cast<std::size_t>(found - points.begin());
        }
        indexed.triangles.push_back(corners);
    }
    return indexed;
}

/// A mesh of one surface holds triangles without normals; those with normals stay on their own.
bool fits_mesh(const NffTriangle& triangle, Triangles triangles) {
    return triangles == Triangles::mesh && !triangle.normals;
}

std::vector<const NffTriangle*> mesh_of(const NffScene& scene, std::uint32_t surface,
                                        Triangles triangles) {
    std::vector<const NffTriangle*> found = triangles_of(scene, surface);
    std::erase_if(found, [&](const NffTriangle* t) { return !fits_mesh(*t, triangles); });
    return found;
}

void write_lrs_surface(const NffSurface& surface, std::size_t index, TextWriter& out) {
    out.print("let m{} = material {{ diffuse: [{}]", index, surface.diffuse * surface.color);
    if (surface.specular > 0.0) {
        out.print(", model: \"phong\", specular: {0}, shininess: {1}, reflect: {0}",
                  surface.specular, std::min(surface.shine, kMaxShininess));
    } else {
        out.print(", model: \"lambert\"");
    }
    if (surface.transmit > 0.0) {
        out.print(", transmit: {}, ior: {}", surface.transmit, surface.index);
    }
    out.print(" }}\n");
}

void write_lrs_triangle(const NffTriangle& t, TextWriter& out) {
    out.print("triangle {{ a: [{}], b: [{}], c: [{}], ", t.points[0], t.points[1], t.points[2]);
    if (t.normals) {
        const auto& n = *t.normals;
        out.print("normals: [[{}], [{}], [{}]], ", n[0], n[1], n[2]);
    }
    out.print("material: m{} }}\n", t.surface);
}

void write_lrs_mesh(const Indexed& mesh, std::size_t surface, TextWriter& out) {
    out.print("mesh {{\n  positions: [\n");
    for (const DVec3& point : mesh.points) out.print("    [{}],\n", point);
    out.print("  ]\n  triangles: [\n");
    for (const auto& t : mesh.triangles) out.print("    [{}, {}, {}],\n", t[0], t[1], t[2]);
    out.print("  ]\n  material: m{}\n}}\n", surface);
}

void write_pov_surface(const NffSurface& surface, std::size_t index, TextWriter& out) {
    // A pigment that transmits T leaves 1 - T of the diffuse light: NFF's T takes none of it.
    const double opaque = std::max(1.0 - surface.transmit, 1e-3);
    out.print("#declare M{} = texture {{ pigment {{ rgbt <{}, {}> }} finish {{ ambient 0 ", index,
              surface.color, surface.transmit);
    out.print("diffuse {}", surface.diffuse / opaque);
    if (surface.specular > 0.0) {
        out.print(" phong {0} phong_size {1} reflection {{ {0} }}", surface.specular,
                  surface.shine);
    }
    out.print(" }} }}\n");
}

std::string pov_material(const NffScene& scene, std::uint32_t surface) {
    const NffSurface& of = scene.surfaces[surface];
    std::string text = fmt::format("texture {{ M{} }}", surface);
    if (of.transmit > 0.0) text += fmt::format(" interior {{ ior {} }}", of.index);
    return text;
}

void write_pov_triangle(const NffTriangle& t, std::string_view material, TextWriter& out) {
    const auto& p = t.points;
    if (t.normals) {
        const auto& n = *t.normals;
        out.print("smooth_triangle {{ <{}>, <{}>, <{}>, ", p[0], n[0], p[1]);
        out.print("<{}>, <{}>, <{}> {} }}\n", n[1], p[2], n[2], material);
    } else {
        out.print("triangle {{ <{}>, <{}>, <{}> {} }}\n", p[0], p[1], p[2], material);
    }
}

void write_pov_mesh(const Indexed& mesh, std::string_view material, TextWriter& out) {
    out.print("mesh2 {{\n  vertex_vectors {{ {}", mesh.points.size());
    for (const DVec3& point : mesh.points) out.print(",\n    <{}>", point);
    out.print("\n  }}\n  face_indices {{ {}", mesh.triangles.size());
    for (const auto& t : mesh.triangles) out.print(",\n    <{}, {}, {}>", t[0], t[1], t[2]);
    out.print("\n  }}\n  {}\n}}\n", material);
}

}  // namespace

void write_lrs(const NffScene& scene, Triangles triangles, TextWriter& out) {
    const NffCamera& camera = scene.camera;
    out.print("camera {{ position: [{}], look_at: [{}], up: [{}], fov: {} }}\n", camera.from,
              camera.at, camera.up, camera.angle);
    out.print("render {{ background: [{}], max_depth: {} }}\n", scene.background, kMaxReflections);
    for (const DVec3& light : scene.lights) {
        out.print("point_light {{ position: [{}], falloff: \"none\", intensity: 4 * pi * {} }}\n",
                  light, light_strength(scene));
    }
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        write_lrs_surface(scene.surfaces[i], i, out);
    }
    for (const NffSphere& s : scene.spheres) {
        out.print("sphere {{ center: [{}], radius: {}, material: m{} }}\n", s.center, s.radius,
                  s.surface);
    }
    for (const NffCone& c : scene.cones) {
        out.print("cylinder {{ from: [{}], to: [{}], radius: {}, ", c.base, c.apex, c.base_radius);
        if (c.apex_radius != c.base_radius) out.print("radius_to: {}, ", c.apex_radius);
        out.print("caps: false, material: m{} }}\n", c.surface);
    }
    for (const NffTriangle& t : scene.triangles) {
        if (!fits_mesh(t, triangles)) write_lrs_triangle(t, out);
    }
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        const auto mesh = mesh_of(scene, i, triangles);
        if (!mesh.empty()) write_lrs_mesh(index_points(mesh), i, out);
    }
}

void write_pov(const NffScene& scene, Triangles triangles, TextWriter& out) {
    const View view = view_of(scene.camera);
    out.print("#version 3.7;\n");
    // The trace level counts what the camera sees, too.
    out.print("global_settings {{ assumed_gamma 1 max_trace_level {} }}\n", kMaxReflections + 1);
    out.print("background {{ rgb <{}> }}\n", scene.background);
    // Explicit vectors: no handedness is left to choose.
    out.print("camera {{ location <{}> direction <{}> ", scene.camera.from, view.forward);
    const double side = 2.0 * view.half_side;
    out.print("right <{}> up <{}> }}\n", side * view.right, side * view.up);
    for (const DVec3& light : scene.lights) {
        out.print("light_source {{ <{}> rgb {} }}\n", light, light_strength(scene));
    }
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        write_pov_surface(scene.surfaces[i], i, out);
    }
    std::vector<std::string> materials;
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        materials.push_back(pov_material(scene, i));
    }
    for (const NffSphere& s : scene.spheres) {
        out.print("sphere {{ <{}>, {} {} }}\n", s.center, s.radius,
                  std::string_view(materials[s.surface]));
    }
    for (const NffCone& c : scene.cones) {
        const std::string_view material = materials[c.surface];
        if (c.apex_radius == c.base_radius) {
            out.print("cylinder {{ <{}>, <{}>, {} open {} }}\n", c.base, c.apex, c.base_radius,
                      material);
        } else {
            out.print("cone {{ <{}>, {}, <{}>, {} open {} }}\n", c.base, c.base_radius, c.apex,
                      c.apex_radius, material);
        }
    }
    for (const NffTriangle& t : scene.triangles) {
        if (!fits_mesh(t, triangles)) write_pov_triangle(t, materials[t.surface], out);
    }
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        const auto mesh = mesh_of(scene, i, triangles);
        if (!mesh.empty()) write_pov_mesh(index_points(mesh), materials[i], out);
    }
}

bool write_tachyon(const NffScene& scene, TextWriter& out) {
    const View view = view_of(scene.camera);
    out.print("BEGIN_SCENE\nRESOLUTION 1024 1024\nCAMERA\n");
    out.print("ZOOM {} ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH {}\n", 0.5 / view.half_side,
              kMaxReflections + 1);
    out.print("CENTER {}\nVIEWDIR {}\nUPDIR {}\nEND_CAMERA\n", Mirrored{scene.camera.from},
              Mirrored{view.forward}, Mirrored{view.up});
    out.print("BACKGROUND {}\n", Spaced{scene.background});
    for (const DVec3& light : scene.lights) {
        out.print("LIGHT CENTER {} RAD 0.001 COLOR {}\n", Mirrored{light},
                  Spaced{DVec3{light_strength(scene)}});
    }
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        const NffSurface& s = scene.surfaces[i];
        out.print("TEXDEF m{} AMBIENT 0 DIFFUSE {} SPECULAR {} OPACITY {} ", i, s.diffuse,
                  s.specular, 1.0 - s.transmit);
        out.print("PHONG PLASTIC {} PHONG_SIZE {} COLOR {} TEXFUNC 0\n", s.specular, s.shine,
                  Spaced{s.color});
    }
    for (const NffSphere& s : scene.spheres) {
        out.print("SPHERE CENTER {} RAD {} m{}\n", Mirrored{s.center}, s.radius, s.surface);
    }
    for (const NffCone& c : scene.cones) {
        if (c.apex_radius != c.base_radius) return false;
        out.print("FCYLINDER BASE {} APEX {} RAD {} m{}\n", Mirrored{c.base}, Mirrored{c.apex},
                  c.base_radius, c.surface);
    }
    for (const NffTriangle& t : scene.triangles) {
        const auto& p = t.points;
        out.print("{} V0 {} V1 {} V2 {}", t.normals ? "STRI" : "TRI", Mirrored{p[0]},
                  Mirrored{p[1]}, Mirrored{p[2]});
        if (t.normals) {
            const auto& n = *t.normals;
            out.print(" N0 {} N1 {} N2 {}", Mirrored{n[0]}, Mirrored{n[1]}, Mirrored{n[2]});
        }
        out.print(" m{}\n", t.surface);
    }
    out.print("END_SCENE\n");
    return true;
}

}  // namespace lray::bench
