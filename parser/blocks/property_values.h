// The properties of one block, by their slot in its schema.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "base/assert.h"
#include "parser/blocks/schema.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Values that fit their property's type and range; those not set read as the schema's default.
class PropertyValues {
 public:
    explicit PropertyValues(std::span<const PropertySchema> properties) : properties_(properties) {}

    bool has(std::size_t slot) const { return values_[slot].kind != ValueKind::none; }
    void set(std::size_t slot, const Value& value) { values_[slot] = value; }
    const Value& operator[](std::size_t slot) const { return values_[slot]; }

    /// Shape: one for each property.
    std::span<const Value> all() const { return {values_.data(), properties_.size()}; }

    double number(std::size_t slot) const {
        const Value& value = values_[slot];
        return value.is(ValueKind::number) ? value.number : properties_[slot].default_value[0];
    }
    bool boolean(std::size_t slot) const {
        const Value& value = values_[slot];
        return value.is(ValueKind::boolean) ? value.boolean
                                            : properties_[slot].default_value[0] != 0.0;
    }
    DVec3 vec3(std::size_t slot) const {
        const Value& value = values_[slot];
        if (value.is(ValueKind::none)) {
            const std::array<double, 3>& fallback = properties_[slot].default_value;
            return {fallback[0], fallback[1], fallback[2]};
        }
        return value.vec3();
    }
    /// Of size2, roughness and resolution.
    DVec2 vec2(std::size_t slot) const {
        const Value& value = values_[slot];
        if (value.is(ValueKind::number)) return DVec2{value.number};
        if (value.is(ValueKind::none)) {
            const std::array<double, 3>& fallback = properties_[slot].default_value;
            return {fallback[0], fallback[1]};
        }
        return {value.numbers[0], value.numbers[1]};
    }
    /// A colour: a colour's own, a vector's numbers, or a number as grey.
    Color color(std::size_t slot) const {
        const Value& value = values_[slot];
        const DVec3 linear = value.is(ValueKind::number) ? DVec3{value.number} : vec3(slot);
        return Color{linear};
    }
    std::optional<Color> optional_color(std::size_t slot) const {
        if (!has(slot)) return std::nullopt;
        return color(slot);
    }
    std::string_view string(std::size_t slot, std::string_view fallback) const {
        const Value& value = values_[slot];
        return value.is(ValueKind::string) ? value.string() : fallback;
    }

 private:
    std::span<const PropertySchema> properties_;
    std::array<Value, kMaxProperties> values_{};
};

}  // namespace lray::parser
