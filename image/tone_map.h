// From the light of a picture to that of a screen: exposure and tone map, applied once to the
// finished picture. The transfer function of the codes is applied when they are written.
#pragma once

#include <cstdint>

#include "base/vec.h"
#include "image/image.h"

namespace lray::image {

/// How bright light is brought into the range of a screen, each channel by itself.
/// `none`: what is brighter than white is white.
/// `reinhard`: x / (1 + x), so that nothing becomes white.
/// `aces`: a film-like curve with a toe and a shoulder.
enum class ToneMap : std::uint8_t { none, reinhard, aces };

/// How a file holds linear values in [0, 1]: by the sRGB transfer function, or as they are.
enum class Gamma : std::uint8_t { srgb, linear };

struct DisplaySettings {
    double exposure = 0.0;  // in stops: light times 2^exposure
    ToneMap tonemap = ToneMap::none;
    Gamma gamma = Gamma::srgb;

    friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

/// Returns 2^stops: exactly for whole numbers, else to a few units in the last place of a double;
/// the same on every processor. Shape: |stops| <= 1000.
double exposure_factor(double stops);

/// What a screen shows of light.
class Display {
 public:
    explicit Display(const DisplaySettings& settings);

    /// True if shown() changes nothing.
    bool is_identity() const { return settings_.tonemap == ToneMap::none && factor_ == 1.0; }

    Gamma gamma() const { return settings_.gamma; }

    /// Returns the light of the screen: linear, 1 is its white. Without a tone map there is more
    /// than white, which writing clamps.
    Color shown(Color light) const;

    /// Returns the standard error of the value in [0, 1] that a file holds of one channel, of whose
    /// light a mean and its standard error are known: the error times the slope of exposure, tone
    /// map and transfer function at the mean. Beyond white, or below black, only the part of the
    /// error that reaches back counts.
    double displayed_error(double mean, double standard_error) const;

 private:
    double curve(double x) const;        // the tone map
    double curve_slope(double x) const;  // its derivative

    DisplaySettings settings_{};
    double factor_ = 1.0;
};

/// Brings a whole picture of light to a screen.
Image displayed(Image picture, const DisplaySettings& settings);

}  // namespace lray::image
