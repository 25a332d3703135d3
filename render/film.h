// Where samples are added up, so that any order and any split of them gives the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "base/assert.h"
#include "base/vec.h"

namespace lray::render {

/// Samples that were not added as they came (--stats).
struct FilmCounts {
    std::uint64_t clamped = 0;  // brighter than Film::kMaxValue
    std::uint64_t nan = 0;      // not a number: added as black; our bug

    FilmCounts& operator+=(const FilmCounts& other) {
        clamped += other.clamped;
        nan += other.nan;
        return *this;
    }
};

/// Sums of samples, each channel as an integer in Q31.32 (steps of 2^-32): integers add up to the
/// same whatever the order. A value that is a multiple of 2^-32 comes back exactly from a single
/// sample: all floats of at least 2^-9, and the smaller ones to within 2^-33.
class Film {
 public:
    static constexpr float kMaxValue = 65504.0f;          // the largest half-precision float
    static constexpr std::uint32_t kMaxSamples = 32'768;  // a pixel: kMaxValue each still fit

    /// What is kept of the samples beside their sums: their squares tell how sure the mean is.
    enum class Keeps : std::uint8_t { sums, squares };

    Film(std::uint32_t width, std::uint32_t height, Keeps keeps = Keeps::sums);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }

    /// Adds a sample: clamped to +-kMaxValue and counted if it was beyond. Asserts that the pixel
    /// has fewer than kMaxSamples.
    void add(std::uint32_t x, std::uint32_t y, const Color& sample);

    /// Returns the mean of the samples of a pixel; black if it has none.
    Color resolve(std::uint32_t x, std::uint32_t y) const;

    /// Returns the standard error of the mean of a pixel: sqrt(variance / n), the variance that of
    /// its samples, estimated without bias. Made of exact integers: any order and any split of the
    /// samples gives the same. Asserts that squares are kept and that there are two samples.
    Color standard_error(std::uint32_t x, std::uint32_t y) const;

    const FilmCounts& counts() const { return counts_; }

 private:
    struct Pixel {
        std::int64_t sum[3] = {0, 0, 0};
        std::uint32_t sample_count = 0;
    };

    __extension__ using Wide = unsigned __int128;

    /// Of each channel. A sample is below 2^48 in steps of 2^-32, its square below 2^96, and
    /// kMaxSamples of them below 2^111.
    struct Squares {
        Wide sum[3] = {0, 0, 0};
    };

    const Pixel& pixel(std::uint32_t x, std::uint32_t y) const {
        LRAY_DCHECK(x < width_ && y < height_);
        return pixels_[std::size_t{y} * width_ + x];
    }

    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    std::vector<Pixel> pixels_;
    std::vector<Squares> squares_;  // empty if they are not kept
    FilmCounts counts_{};
};

}  // namespace lray::render
