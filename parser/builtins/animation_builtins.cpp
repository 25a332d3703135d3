// Functions of time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/did_you_mean.h"
#include "parser/builtins/blend.h"
#include "parser/builtins/families.h"
#include "parser/builtins/results.h"

namespace lray::parser {

namespace {

enum class Ease : std::uint8_t { smooth, linear, step };
constexpr std::array<std::string_view, 3> kEases = {"smooth", "linear", "step"};

std::optional<Ease> ease_of(Call& call) {
    if (call[2].is(ValueKind::none)) return Ease::smooth;
    const std::string_view name = call[2].string();
    const auto found = std::ranges::find(kEases, name);
    if (found != kEases.end()) return static_cast<Ease>(found - kEases.begin());
    call.diagnostics
        .error(Code::E0403, call.spans[2], "`ease` of `keys` is \"smooth\", \"linear\" or \"step\"")
        .with_hint(did_you_mean(name, kEases));
    return std::nullopt;
}

struct Key {
    double time = 0.0;
    Value value{};
};

std::optional<Key> key_of(const Value& pair) {
    if (!pair.is_list() || pair.is(ValueKind::rows) || pair.count != 2) return std::nullopt;
    const Value time = element(pair, 0);
    const Value value = element(pair, 1);
    if (!time.is(ValueKind::number) || !fits(ParameterType::blendable, value)) return std::nullopt;
    return Key{time.number, value};
}

/// Errors: empty; E0301 and E0304 reported at the list.
std::optional<std::vector<Key>> keys_of(Call& call) {
    const Value& list = call[0];
    const std::uint64_t size = list.count * sizeof(Key);
    if (!take_bytes(call.budget, size, call.span, call.diagnostics)) return std::nullopt;
    if (!take_steps(call, list.count)) return std::nullopt;
    std::vector<Key> keys;
    keys.reserve(list.count);
    for (std::uint32_t i = 0; i < list.count; ++i) {
        const std::optional<Key> key = key_of(element(list, i));
        if (!key) {
            call.diagnostics.error(
                Code::E0301, call.spans[0],
                fmt::format("`keys` needs pairs of a time and a number, vector or colour, like "
                            "[[0, 1], [2, 5]]; element {} is {}",
                            i, describe(element(list, i))));
            return std::nullopt;
        }
        if (i > 0 && !(key->time > keys.back().time)) {
            call.diagnostics.error(
                Code::E0304, call.spans[0],
                fmt::format("the times of keys must increase: {} follows {}",
                            format_number(key->time), format_number(keys.back().time)));
            return std::nullopt;
        }
        keys.push_back(*key);
    }
    call.budget.value_bytes += size;  // given back
    return keys;
}

Value keys_at(Call& call) {
    if (call[0].count == 0) return nothing_in_list(call, 0);
    const std::optional<Ease> ease = ease_of(call);
    const std::optional<std::vector<Key>> keys = keys_of(call);
    if (!ease || !keys) return Value::poison();
    const double time = call.number(1);
    const auto next = std::ranges::upper_bound(*keys, time, {}, &Key::time);
    if (next == keys->begin()) return next->value;
    const Key& before = next[-1];
    if (next == keys->end() || *ease == Ease::step) return before.value;
    // Halved, so that differences stay finite.
    const double t = (time / 2 - before.time / 2) / (next->time / 2 - before.time / 2);
    const double eased = *ease == Ease::smooth ? t * t * (3.0 - 2.0 * t) : t;
    return blend(call, before.value, next->value, eased);
}

using enum ParameterType;

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"keys", {{{"list", list}, {"t", number}, {"ease", string, true}}}, keys_at, "the value at the time t of [[t0, value0], [t1, value1], ...]; ease: smooth, linear or step"},
};
// clang-format on

}  // namespace

std::span<const Builtin> animation_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
