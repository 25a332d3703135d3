// Worley noise: the distance to the nearest feature point of a jittered lattice.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/lattice.h"
#include "base/noise.h"

namespace lray {

namespace {

double square(double x) {
    return x * x;
}

std::uint64_t neighbor(std::uint64_t index, int offset) {
    return index + static_cast<std::uint64_t>(static_cast<std::int64_t>(offset));
}

/// The squared distance along one axis to the cell `offset` cells on.
double squared_gap(const LatticeCell& cell, int offset) {
    if (offset == 0) return 0.0;
    return square(offset > 0 ? offset - cell.inside : cell.inside - (offset + 1));
}

/// The least distance that cells more than one away can have, along one axis.
double gap_beyond_neighbors(const LatticeCell& cell) {
    return 1.0 + std::min(cell.inside, 1.0 - cell.inside);
}

/// Cells within one of the own are searched; the next ones only if they may hold a nearer point.
/// No point is farther than that of the own cell, at most sqrt(3) < 2, so two are enough.
template <class NearestWithin>
double distance_to_nearest(double gap_beyond, NearestWithin nearest_within) {
    const double infinity = std::numeric_limits<double>::infinity();
    double nearest = nearest_within(1, infinity);
    if (nearest > square(gap_beyond)) nearest = nearest_within(2, nearest);
    return std::sqrt(nearest);
}

}  // namespace

double worley(double p, NoiseSeed seed) {
    const LatticeCell x(p);
    const auto nearest_within = [&](int reach, double nearest) {
        for (int i = -reach; i <= reach; ++i) {
            const std::uint64_t hash = lattice_hash(seed.bits, neighbor(x.index, i));
            nearest = std::min(nearest, square(i + first_third(hash) - x.inside));
        }
        return nearest;
    };
    return distance_to_nearest(gap_beyond_neighbors(x), nearest_within);
}

double worley(DVec2 p, NoiseSeed seed) {
    const LatticeCell x(p.x);
    const LatticeCell y(p.y);
    const auto nearest_within = [&](int reach, double nearest) {
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) {
                if (squared_gap(x, i) + squared_gap(y, j) >= nearest) continue;
                const std::uint64_t hash =
                    lattice_hash(seed.bits, neighbor(x.index, i), neighbor(y.index, j));
                nearest = std::min(nearest, square(i + first_third(hash) - x.inside) +
                                                square(j + second_third(hash) - y.inside));
            }
        }
        return nearest;
    };
    return distance_to_nearest(std::min(gap_beyond_neighbors(x), gap_beyond_neighbors(y)),
                               nearest_within);
}

double worley(DVec3 p, NoiseSeed seed) {
    const LatticeCell x(p.x);
    const LatticeCell y(p.y);
    const LatticeCell z(p.z);
    const auto nearest_within = [&](int reach, double nearest) {
        for (int k = -reach; k <= reach; ++k) {
            for (int j = -reach; j <= reach; ++j) {
                const double gap = squared_gap(z, k) + squared_gap(y, j);
                if (gap >= nearest) continue;
                for (int i = -reach; i <= reach; ++i) {
                    if (gap + squared_gap(x, i) >= nearest) continue;
                    const std::uint64_t hash =
                        lattice_hash(seed.bits, neighbor(x.index, i), neighbor(y.index, j),
                                     neighbor(z.index, k));
                    nearest = std::min(nearest, square(i + first_third(hash) - x.inside) +
                                                    square(j + second_third(hash) - y.inside) +
                                                    square(k + last_third(hash) - z.inside));
                }
            }
        }
        return nearest;
    };
    return distance_to_nearest(
        std::min({gap_beyond_neighbors(x), gap_beyond_neighbors(y), gap_beyond_neighbors(z)}),
        nearest_within);
}

}  // namespace lray
