// Where samples are added up, so that any order and any split of them gives the same bits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "base/assert.h"
#include "base/numerics.h"
#include "base/vec.h"
#include "image/image.h"

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
    friend FilmCounts operator-(const FilmCounts& a, const FilmCounts& b) {
        return {a.clamped - b.clamped, a.nan - b.nan};
    }
};

/// Sums of samples, each channel as an integer in Q31.32 (steps of 2^-32): integers add up to the
/// same whatever the order. A value that is a multiple of 2^-32 comes back exactly from a single
/// sample: all floats of at least 2^-9, and the smaller ones to within 2^-33.
class Film {
 public:
    static constexpr float kMaxValue = 65504.0f;          // the largest half-precision float
    static constexpr std::uint32_t kMaxSamples = 32'768;  // a pixel: kMaxValue each still fit
    static constexpr double kStepsOfOne = 0x1p32;         // of which 1.0 is made

    /// What is kept of the samples beside their sums: their squares tell how sure the mean is.
    enum class Keeps : std::uint8_t { sums, squares };

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

    Film(std::uint32_t width, std::uint32_t height, Keeps keeps = Keeps::sums);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }

    /// Adds a sample: clamped to +-kMaxValue and counted if it was beyond. Asserts that the pixel
    /// has fewer than kMaxSamples.
    void add(std::uint32_t x, std::uint32_t y, const Color& sample) {
        LRAY_DCHECK(x < width_ && y < height_);
        const std::size_t place = std::size_t{y} * width_ + x;
        Pixel& target = pixels_[place];
        LRAY_ASSERT(target.sample_count < kMaxSamples);
        ++target.sample_count;
        if (std::isnan(sample.r) || std::isnan(sample.g) || std::isnan(sample.b)) {
            ++counts_.nan;
            return;
        }
        bool is_clamped = false;
        const std::int64_t steps[3] = {steps_of(sample.r, is_clamped),
                                       steps_of(sample.g, is_clamped),
                                       steps_of(sample.b, is_clamped)};
        for (int channel = 0; channel < 3; ++channel) target.sum[channel] += steps[channel];
        counts_.clamped += is_clamped ? 1 : 0;
        if (squares_.empty()) return;
        for (int channel = 0; channel < 3; ++channel) {
            const Wide size = static_cast<std::uint64_t>(std::abs(steps[channel]));
            squares_[place].sum[channel] += size * size;
        }
    }

    /// Returns the mean of the samples of a pixel; black if it has none.
    Color resolve(std::uint32_t x, std::uint32_t y) const {
        const Pixel& source = pixel(x, y);
        if (source.sample_count == 0) return Color{0.0f};
        const double scale = 1.0 / (kStepsOfOne * source.sample_count);  // of one sample exact
        return {light_of(source.sum[0], scale), light_of(source.sum[1], scale),
                light_of(source.sum[2], scale)};
    }

    /// Returns the standard error of the mean of a pixel: sqrt(variance / n), the variance that of
    /// its samples, estimated without bias. Made of exact integers: any order and any split of the
    /// samples gives the same. Asserts that squares are kept and that there are two samples.
    Color standard_error(std::uint32_t x, std::uint32_t y) const;

    const FilmCounts& counts() const { return counts_; }
    void add_counts(const FilmCounts& counts) { counts_ += counts; }

    Keeps keeps() const { return squares_.empty() ? Keeps::sums : Keeps::squares; }

    const Pixel& pixel(std::uint32_t x, std::uint32_t y) const {
        LRAY_DCHECK(x < width_ && y < height_);
        return pixels_[std::size_t{y} * width_ + x];
    }

    /// Returns how many samples all pixels have together.
    std::uint64_t sample_count() const;

    /// Row by row from the top left; squares are empty if they are not kept.
    std::span<const Pixel> pixels() const { return pixels_; }
    std::span<const Squares> squares() const { return squares_; }
    std::span<Pixel> pixels() { return pixels_; }
    std::span<Squares> squares() { return squares_; }

    /// Returns the part that begins at (x, y), without counts. Shape: it lies inside.
    Film part(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) const;

    /// Puts a part, without its counts, in the place of what is there. Shape: likewise; both keep
    /// the same.
    void set_part(std::uint32_t x, std::uint32_t y, const Film& part);

    /// Adds the samples of another film, and its counts. Shape: of one size; both keep the same.
    /// Errors: asserts that no pixel has more than kMaxSamples then.
    void add_film(const Film& other);

    /// Returns the means of all pixels.
    image::Image picture() const;

 private:
    static std::int64_t steps_of(float light, bool& is_clamped) {
        const float value = std::clamp(light, -kMaxValue, kMaxValue);
        is_clamped = is_clamped || value != light;
        return nearest_whole(static_cast<double>(value) * kStepsOfOne);  // exact product
    }
    static float light_of(std::int64_t sum, double scale) {
        return static_cast<float>(static_cast<double>(sum) * scale);
    }

    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    std::vector<Pixel> pixels_;
    std::vector<Squares> squares_;  // empty if they are not kept
    FilmCounts counts_{};
};

/// What a film keeps where pixels end by their noise (SampleLimits), or do not.
inline Film::Keeps film_keeps(const std::optional<double>& noise) {
    return noise ? Film::Keeps::squares : Film::Keeps::sums;
}

}  // namespace lray::render
