// Noise as functions of the language: of a number, or of a point of two or three.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "base/noise.h"
#include "parser/builtins/families.h"
#include "parser/builtins/random_key.h"

namespace lray::parser {

namespace {

NoiseSeed seed_of(Call& call, const Value& seed) {
    return NoiseSeed(
        with_key(call, KeyedRandom{}, seed.is(ValueKind::none) ? Value::of(0.0) : seed));
}

/// Calls `function` with the position as a number, DVec2 or DVec3.
template <class Function>
double at_position(const Value& p, Function function) {
    if (p.is(ValueKind::number)) return function(p.number);
    if (p.count == 2) return function(DVec2{p.numbers[0], p.numbers[1]});
    return function(p.vec3());
}

Value finite(Call& call, double result) {
    if (std::isfinite(result)) return Value::of(result);
    call.diagnostics.error(
        Code::E0503, call.span,
        fmt::format("`{}` has no value here: its octaves are too many or too far away", call.name));
    return Value::poison();
}

Value noise_of(Call& call) {
    const NoiseSeed seed = seed_of(call, call[1]);
    return finite(call, at_position(call[0], [&](auto p) { return noise(p, seed); }));
}

Value worley_of(Call& call) {
    const NoiseSeed seed = seed_of(call, call[1]);
    return finite(call, at_position(call[0], [&](auto p) { return worley(p, seed); }));
}

/// The octaves of fbm and ridged. Errors: empty, E0304 and E0512 reported.
std::optional<Octaves> octaves_of(Call& call) {
    const auto refuse = [&](std::size_t i, std::string_view wanted) {
        call.diagnostics.error(Code::E0304, call.spans[i],
                               fmt::format("`{}` of `{}` must be {}, this is {}",
                                           i == 1   ? "octaves"
                                           : i == 2 ? "lacunarity"
                                                    : "gain",
                                           call.name, wanted, format_number(call.number(i))));
        return std::nullopt;
    };
    Octaves octaves;
    if (call[1].is(ValueKind::number)) {
        if (!(call.number(1) >= 1.0 && call.number(1) <= Octaves::kMaxCount)) {
            return refuse(1, fmt::format("from 1 to {}", Octaves::kMaxCount));
        }
        octaves.count = static_cast<int>(call.number(1));
    }
    if (call[2].is(ValueKind::number)) {
        if (!(call.number(2) > 0.0)) return refuse(2, "greater than 0");
        octaves.lacunarity = call.number(2);
    }
    if (call[3].is(ValueKind::number)) {
        if (!(call.number(3) >= 0.0)) return refuse(3, "0 or greater");
        octaves.gain = call.number(3);
    }
    return octaves;
}

Value fbm_of(Call& call) {
    const std::optional<Octaves> octaves = octaves_of(call);
    if (!octaves) return Value::poison();
    const NoiseSeed seed = seed_of(call, call[4]);
    return finite(call, at_position(call[0], [&](auto p) { return fbm(p, *octaves, seed); }));
}

Value ridged_of(Call& call) {
    const std::optional<Octaves> octaves = octaves_of(call);
    if (!octaves) return Value::poison();
    const NoiseSeed seed = seed_of(call, call[4]);
    return finite(call, at_position(call[0], [&](auto p) { return ridged(p, *octaves, seed); }));
}

using enum ParameterType;

constexpr Parameter kP{"p", position};
constexpr Parameter kOctaves{"octaves", integer, true};
constexpr Parameter kLacunarity{"lacunarity", number, true};
constexpr Parameter kGain{"gain", number, true};
constexpr Parameter kSeed{"seed", key, true};

// clang-format off
constexpr std::array kNoise = {
    Builtin{"noise", {{kP, kSeed}}, noise_of, "smooth noise, -1 to 1; 0 where all of p is whole"},
    Builtin{"fbm", {{kP, kOctaves, kLacunarity, kGain, kSeed}}, fbm_of, "clouds and hills: 5 octaves of noise, -1 to 1"},
    Builtin{"ridged", {{kP, kOctaves, kLacunarity, kGain, kSeed}}, ridged_of, "mountains: as `fbm`, with sharp crests near 1"},
    Builtin{"worley", {{kP, kSeed}}, worley_of, "cells: distance to the nearest of points strewn one in each unit cell, 0 to about 1"},
};
// clang-format on

}  // namespace

std::span<const Builtin> noise_builtins() {
    return kNoise;
}

}  // namespace lray::parser
