// Writes large inputs for read_speed: the same bytes every time, everywhere.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/output_file.h"
#include "bench/text_writer.h"

namespace {

using lray::bench::TextWriter;

constexpr std::string_view kUsage =
    "usage: make_scene_text triangles|points|painted|obj|ply|ply_text COUNT PATH\n"
    "  triangles  COUNT literal triangle blocks, one on a line (.lrs)\n"
    "  painted    COUNT spheres, one on a line, each with a material by its name (.lrs)\n"
    "  points     one packed list of COUNT points, one on a line (.lrs)\n"
    "  obj        a height field of about COUNT triangles, positions and faces only (.obj)\n"
    "  ply        the same in binary, little endian (.ply)\n"
    "  ply_text   the same in text (.ply)\n";

/// Coordinates in [-1000, 1000) with four decimals.
/// Source: SplitMix64, Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators".
class Coordinates {
 public:
    double next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
        constexpr std::uint64_t kCount = 20'000'000;
        return static_cast<double>(z % kCount) / 10'000.0 - 1000.0;
    }

 private:
    std::uint64_t state_ = 1;
};

void write_triangles(std::uint64_t count, TextWriter& out) {
    Coordinates random;
    const auto point = [&](const char* name, const char* end) {
        const double x = random.next();
        const double y = random.next();
        const double z = random.next();
        out.print("{}: [{:.4f}, {:.4f}, {:.4f}]{}", name, x, y, z, end);
    };
    for (std::uint64_t i = 0; i < count; ++i) {
        out.print("triangle {{ ");
        point("a", ", ");
        point("b", ", ");
        point("c", " }\n");
    }
}

void write_painted(std::uint64_t count, TextWriter& out) {
    Coordinates random;
    out.print("let red = material {{ diffuse: crimson }}\n");
    for (std::uint64_t i = 0; i < count; ++i) {
        const double x = random.next();
        const double y = random.next();
        const double z = random.next();
        out.print("sphere {{ center: [{:.4f}, {:.4f}, {:.4f}], material: red }}\n", x, y, z);
    }
}

void write_points(std::uint64_t count, TextWriter& out) {
    Coordinates random;
    out.print("let points = [\n");
    for (std::uint64_t i = 0; i < count; ++i) {
        const double x = random.next();
        const double y = random.next();
        const double z = random.next();
        out.print("[{:.4f}, {:.4f}, {:.4f}],\n", x, y, z);
    }
    out.print("]\n");
}

void write_obj(std::uint64_t count, TextWriter& out) {
    // Two triangles in each of side x side cells.
    const auto side = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count) / 2.0));
    Coordinates random;
    for (std::uint64_t y = 0; y <= side; ++y) {
        for (std::uint64_t x = 0; x <= side; ++x) {
            out.print("v {:.6f} {:.6f} {:.6f}\n", static_cast<double>(x) / 64.0,
                      random.next() / 1000.0, static_cast<double>(y) / 64.0);
        }
    }
    for (std::uint64_t y = 0; y < side; ++y) {
        for (std::uint64_t x = 0; x < side; ++x) {
            const std::uint64_t here = y * (side + 1) + x + 1;
            const std::uint64_t below = here + side + 1;
            out.print("f {} {} {}\nf {} {} {}\n", here, below, here + 1, here + 1, below,
                      below + 1);
        }
    }
}

template <class T>
void put(T value, TextWriter& out) {
    out.add({reinterpret_cast<const char*>(&value), sizeof value});
}

void write_ply(std::uint64_t count, TextWriter& out, bool is_text) {
    const auto side = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count) / 2.0));
    out.print(
        "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
        "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        is_text ? "ascii" : "binary_little_endian", (side + 1) * (side + 1), 2 * side * side);
    Coordinates random;
    for (std::uint64_t y = 0; y <= side; ++y) {
        for (std::uint64_t x = 0; x <= side; ++x) {
            const double height = random.next() / 1000.0;
            const double across = static_cast<double>(x) / 64.0;
            const double along = static_cast<double>(y) / 64.0;
            if (is_text) {
                out.print("{:.6f} {:.6f} {:.6f}\n", across, height, along);
                continue;
            }
            for (const double p : {across, height, along}) put(static_cast<float>(p), out);
        }
    }
    const auto triangle = [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
        if (is_text) {
            out.print("3 {} {} {}\n", a, b, c);
            return;
        }
        put(std::uint8_t{3}, out);
        for (const std::uint64_t i : {a, b, c}) put(static_cast<std::int32_t>(i), out);
    };
    for (std::uint64_t y = 0; y < side; ++y) {
        for (std::uint64_t x = 0; x < side; ++x) {
            const std::uint64_t here = y * (side + 1) + x;
            const std::uint64_t below = here + side + 1;
            triangle(here, below, here + 1);
            triangle(here + 1, below, below + 1);
        }
    }
}

void write_ply_binary(std::uint64_t count, TextWriter& out) {
    write_ply(count, out, false);
}

void write_ply_text(std::uint64_t count, TextWriter& out) {
    write_ply(count, out, true);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view kind = argc == 4 ? argv[1] : "";
    char* end = nullptr;
    const std::uint64_t count = argc == 4 ? std::strtoull(argv[2], &end, 10) : 0;
    const auto write = kind == "triangles"  ? write_triangles
                       : kind == "painted"  ? write_painted
                       : kind == "points"   ? write_points
                       : kind == "obj"      ? write_obj
                       : kind == "ply"      ? write_ply_binary
                       : kind == "ply_text" ? write_ply_text
                                            : nullptr;
    if (write == nullptr || count == 0 || *end != '\0') {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    std::string error;
    std::optional<lray::OutputFile> file = lray::OutputFile::open(argv[3], error);
    if (!file) {
        fmt::print(stderr, "{}: {}\n", argv[3], error);
        return 4;
    }
    TextWriter out(*file);
    write(count, out);
    if (!out.finish()) {
        fmt::print(stderr, "{}: {}\n", argv[3], file->error());
        return 4;
    }
    return 0;
}
