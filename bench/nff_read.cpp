// Reading: NFF, and OBJ as if it were NFF.
#include "bench/nff_scene.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>

namespace lray::bench {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Words and numbers of a text, one after the other.
class Words {
 public:
    explicit Words(std::string_view text) : text_(text) {}

    /// Returns the next word; empty at the end of the text.
    std::string_view next() {
        while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
            if (text_[at_] == '#') {
                skip_line();
            } else {
                line_ += text_[at_++] == '\n' ? 1 : 0;
            }
        }
        const std::size_t first = at_;
        while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
        return text_.substr(first, at_ - first);
    }

    double number() {
        const std::string_view word = next();
        double value = 0.0;
        const auto [rest, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (code != std::errc{} || rest != word.data() + word.size()) {
            fail(fmt::format("`{}` is not a number", word));
        }
        return value;
    }

    DVec3 vector() {
        const double x = number();
        const double y = number();
        return {x, y, number()};
    }

    /// Returns what is left of the line behind the last word.
    std::string_view rest_of_line() {
        const std::size_t first = at_;
        skip_line();
        return text_.substr(first, at_ - first);
    }

    void fail(std::string message) {
        if (error_.empty()) error_ = fmt::format("line {}: {}", line_, message);
    }
    bool has_failed() const { return !error_.empty(); }
    const std::string& error() const { return error_; }

 private:
    void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::string error_{};
};

std::uint32_t add_surface(NffScene& scene, const NffSurface& surface) {
    const auto found = std::find(scene.surfaces.begin(), scene.surfaces.end(), surface);
    const auto index = static_cast<std::uint32_t>(found - scene.surfaces.begin());
    if (found == scene.surfaces.end()) scene.surfaces.push_back(surface);
    return index;
}

void add_fan(NffScene& scene, std::uint32_t surface, const std::vector<DVec3>& points,
             const std::vector<DVec3>& normals) {
    for (std::size_t i = 2; i < points.size(); ++i) {
        NffTriangle triangle{surface, {points[0], points[i - 1], points[i]}, {}};
        if (!normals.empty()) triangle.normals = {normals[0], normals[i - 1], normals[i]};
        scene.triangles.push_back(triangle);
    }
}

void read_polygon(Words& words, bool has_normals, std::uint32_t surface, NffScene& scene) {
    const double count = words.number();
    if (words.has_failed()) return;
    if (!(count >= 3.0 && count <= 1000.0)) {
        words.fail("a polygon has 3 to 1000 corners");
        return;
    }
    std::vector<DVec3> points;
    std::vector<DVec3> normals;
    for (int i = 0; i < static_cast<int>(count); ++i) {
        points.push_back(words.vector());
        if (has_normals) normals.push_back(words.vector());
    }
    add_fan(scene, surface, points, normals);
}

void read_camera(Words& words, NffCamera& camera) {
    const auto expect = [&](std::string_view expected) {
        const std::string_view word = words.next();
        if (word != expected) words.fail(fmt::format("`{}` where `{}` belongs", word, expected));
    };
    expect("from");
    camera.from = words.vector();
    expect("at");
    camera.at = words.vector();
    expect("up");
    camera.up = words.vector();
    expect("angle");
    camera.angle = words.number();
    expect("hither");
    words.number();
    expect("resolution");
    words.number();
    words.number();
}

NffSurface read_surface(Words& words) {
    NffSurface surface;
    surface.color = words.vector();
    surface.diffuse = words.number();
    surface.specular = words.number();
    surface.shine = words.number();
    surface.transmit = words.number();
    surface.index = words.number();
    return surface;
}

}  // namespace

std::optional<NffScene> read_nff(std::string_view text, std::string& error) {
    NffScene scene;
    Words words(text);
    std::optional<std::uint32_t> surface;
    for (std::string_view word = words.next(); !word.empty() && !words.has_failed();
         word = words.next()) {
        const bool is_shape = word == "s" || word == "c" || word == "p" || word == "pp";
        if (is_shape && !surface) {
            words.fail(fmt::format("`{}` before the first `f`", word));
        } else if (word == "b") {
            scene.background = words.vector();
        } else if (word == "v") {
            read_camera(words, scene.camera);
        } else if (word == "l") {
            scene.lights.push_back(words.vector());
            words.rest_of_line();  // a colour, which few files have
        } else if (word == "f") {
            surface = add_surface(scene, read_surface(words));
        } else if (word == "s") {
            const DVec3 center = words.vector();
            scene.spheres.push_back({*surface, center, words.number()});
        } else if (word == "c") {
            const DVec3 base = words.vector();
            const double base_radius = words.number();
            const DVec3 apex = words.vector();
            scene.cones.push_back({*surface, base, base_radius, apex, words.number()});
        } else if (is_shape) {
            read_polygon(words, word == "pp", *surface, scene);
        } else {
            words.fail(fmt::format("nothing is called `{}`", word));
        }
    }
    error = words.error();
    if (words.has_failed()) return std::nullopt;
    return scene;
}

std::optional<NffScene> read_obj_scene(std::string_view text, std::string& error) {
    NffScene scene;
    scene.surfaces.push_back({});
    scene.background = {0.078, 0.361, 0.753};
    Words words(text);
    std::vector<DVec3> vertices;
    for (std::string_view word = words.next(); !word.empty() && !words.has_failed();
         word = words.next()) {
        if (word == "v") {
            vertices.push_back(words.vector());
        } else if (word == "f") {
            Words corners(words.rest_of_line());
            std::vector<DVec3> points;
            for (std::string_view corner = corners.next(); !corner.empty();
                 corner = corners.next()) {
                const double index = Words(corner.substr(0, corner.find('/'))).number();
                if (!(index >= 1.0 && index <= static_cast<double>(vertices.size()))) {
                    words.fail(fmt::format("`{}` is no vertex", corner));
                    break;
                }
                points.push_back(vertices[static_cast<std::size_t>(index) - 1]);
            }
            add_fan(scene, 0, points, {});
        } else {
            words.rest_of_line();
        }
    }
    if (!words.has_failed() && scene.triangles.empty()) words.fail("there are no faces");
    error = words.error();
    if (words.has_failed()) return std::nullopt;

    DVec3 low{std::numeric_limits<double>::infinity()};
    DVec3 high = -low;
    for (const DVec3& vertex : vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const DVec3 middle = 0.5 * (low + high);
    const double size = glm::length(high - low);
    scene.camera = {middle + size * DVec3{0.5, 0.3, 1.0}, middle, {0.0, 1.0, 0.0}, 45.0};
    scene.lights.push_back(middle + size * DVec3{-2.0, 3.0, 2.5});
    return scene;
}

}  // namespace lray::bench
