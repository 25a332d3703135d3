// Gradient noise on a hashed lattice, and sums of its octaves.
#include "base/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/lattice.h"
#include "base/portable_math.h"

namespace lray {

namespace {

// The fade curve of Perlin 2002: 6t^5 - 15t^4 + 10t^3, flat to the second derivative at 0 and 1.
double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double blend(double t, double a, double b) {
    return a + t * (b - a);
}

constexpr std::size_t kDirectionCount = 64;

constexpr std::array<DVec2, kDirectionCount> kDirections = [] {
    std::array<DVec2, kDirectionCount> directions{};
    for (std::size_t i = 0; i < kDirectionCount; ++i) {
        directions[i] = unit_circle_point((static_cast<double>(i) + 0.5) / kDirectionCount);
    }
    return directions;
}();

// The middles of a cube's edges: no two of them close together (Perlin 2002).
constexpr std::array<DVec3, 12> kEdges = {{{1, 1, 0},
                                           {-1, 1, 0},
                                           {1, -1, 0},
                                           {-1, -1, 0},
                                           {1, 0, 1},
                                           {-1, 0, 1},
                                           {1, 0, -1},
                                           {-1, 0, -1},
                                           {0, 1, 1},
                                           {0, -1, 1},
                                           {0, 1, -1},
                                           {0, -1, -1}}};

// What the gradients above can add up to at most, found by maximising over the cell with the best
// gradient at each corner: at the middle of the cell, but for 3 dimensions.
constexpr double kMax1 = 0.5;
constexpr double kMax2 = 0.70710678118654757;
constexpr double kMax3 = 1.0363538112118027;

double along_gradient(std::uint64_t hash, double from_corner) {
    return (static_cast<double>(hash >> 11) * 0x1p-52 - 1.0) * from_corner;
}
double along_gradient(std::uint64_t hash, double x, double y) {
    const DVec2& gradient = kDirections[hash >> 58];
    return gradient.x * x + gradient.y * y;
}
double along_gradient(std::uint64_t hash, double x, double y, double z) {
    const DVec3& gradient = kEdges[((hash >> 32) * kEdges.size()) >> 32];
    return gradient.x * x + gradient.y * y + gradient.z * z;
}

double scaled(double sum, double max) {
    return std::clamp(sum / max, -1.0, 1.0);  // rounding may go one step too far; NaN stays
}

/// A third of the 64 bits each, as numbers in [0, 1).
double moved(double p, std::uint64_t bits) {
    return p + first_third(bits);
}
DVec2 moved(DVec2 p, std::uint64_t bits) {
    return {p.x + first_third(bits), p.y + second_third(bits)};
}
DVec3 moved(DVec3 p, std::uint64_t bits) {
    return {p.x + first_third(bits), p.y + second_third(bits), p.z + last_third(bits)};
}

/// Octave after octave, each with a lattice of its own.
template <class Point>
class OctaveWalk {
 public:
    OctaveWalk(Point p, const Octaves& octaves, NoiseSeed seed)
        : point_(p), octaves_(octaves), seed_(seed) {}

    double next() {
        seed_.bits = mix_bits(seed_.bits + kStep);
        const double value = noise(moved(point_, seed_.bits), seed_);
        point_ *= octaves_.lacunarity;
        return value;
    }

    void skip() {
        seed_.bits = mix_bits(seed_.bits + kStep);
        point_ *= octaves_.lacunarity;
    }

 private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;  // SplitMix64's

    Point point_;
    const Octaves& octaves_;
    NoiseSeed seed_;
};

template <class Point>
double fbm_of(Point p, const Octaves& octaves, NoiseSeed seed, double width = 0.0) {
    OctaveWalk<Point> walk(p, octaves, seed);
    double sum = 0.0;
    double weights = 0.0;
    double weight = 1.0;
    for (int i = 0; i < octaves.count; ++i) {
        const double left = noise_left(width);
        if (left > 0.0) {
            sum += weight * left * walk.next();
        } else {
            walk.skip();
        }
        weights += weight;
        weight *= octaves.gain;
        width *= octaves.lacunarity;
    }
    return sum / weights;
}

template <class Point>
double ridged_of(Point p, const Octaves& octaves, NoiseSeed seed) {
    constexpr double kSharpness = 2.0;  // Musgrave's gain: how soon detail shows beside a crest
    OctaveWalk<Point> walk(p, octaves, seed);
    double sum = 0.0;
    double weights = 0.0;
    double weight = 1.0;
    double detail = 1.0;
    for (int i = 0; i < octaves.count; ++i) {
        const double crest = 1.0 - std::fabs(walk.next());
        const double signal = crest * crest * detail;
        sum += weight * signal;
        weights += weight;
        weight *= octaves.gain;
        detail = std::min(signal * kSharpness, 1.0);
    }
    return 2.0 * (sum / weights) - 1.0;
}

}  // namespace

double noise(double p, NoiseSeed seed) {
    const LatticeCell x(p);
    const auto corner = [&](std::uint64_t i) {
        return along_gradient(lattice_hash(seed.bits, x.index + i),
                              x.inside - static_cast<double>(i));
    };
    return scaled(blend(fade(x.inside), corner(0), corner(1)), kMax1);
}

double noise(DVec2 p, NoiseSeed seed) {
    const LatticeCell x(p.x);
    const LatticeCell y(p.y);
    const double tx = fade(x.inside);
    const auto corner = [&](std::uint64_t i, std::uint64_t j) {
        return along_gradient(lattice_hash(seed.bits, x.index + i, y.index + j),
                              x.inside - static_cast<double>(i), y.inside - static_cast<double>(j));
    };
    const auto side = [&](std::uint64_t j) { return blend(tx, corner(0, j), corner(1, j)); };
    return scaled(blend(fade(y.inside), side(0), side(1)), kMax2);
}

double noise(DVec3 p, NoiseSeed seed) {
    const LatticeCell x(p.x);
    const LatticeCell y(p.y);
    const LatticeCell z(p.z);
    const double tx = fade(x.inside);
    const double ty = fade(y.inside);
    const auto corner = [&](std::uint64_t i, std::uint64_t j, std::uint64_t k) {
        return along_gradient(lattice_hash(seed.bits, x.index + i, y.index + j, z.index + k),
                              x.inside - static_cast<double>(i), y.inside - static_cast<double>(j),
                              z.inside - static_cast<double>(k));
    };
    const auto side = [&](std::uint64_t j, std::uint64_t k) {
        return blend(tx, corner(0, j, k), corner(1, j, k));
    };
    const auto face = [&](std::uint64_t k) { return blend(ty, side(0, k), side(1, k)); };
    return scaled(blend(fade(z.inside), face(0), face(1)), kMax3);
}

double fbm(double p, const Octaves& octaves, NoiseSeed seed) {
    return fbm_of(p, octaves, seed);
}
double fbm(DVec2 p, const Octaves& octaves, NoiseSeed seed) {
    return fbm_of(p, octaves, seed);
}
double fbm(DVec3 p, const Octaves& octaves, NoiseSeed seed) {
    return fbm_of(p, octaves, seed);
}
double fbm(DVec3 p, const Octaves& octaves, NoiseSeed seed, double width) {
    return fbm_of(p, octaves, seed, width);
}

double ridged(double p, const Octaves& octaves, NoiseSeed seed) {
    return ridged_of(p, octaves, seed);
}
double ridged(DVec2 p, const Octaves& octaves, NoiseSeed seed) {
    return ridged_of(p, octaves, seed);
}
double ridged(DVec3 p, const Octaves& octaves, NoiseSeed seed) {
    return ridged_of(p, octaves, seed);
}

}  // namespace lray
