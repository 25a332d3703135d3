// The properties of one block, by their slot in its schema.
#pragma once

#include <array>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "base/assert.h"
#include "parser/blocks/schema.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Values that fit their property's type and range; those not set read as the schema's default.
class PropertyValues {
 public:
    explicit PropertyValues(std::span<const PropertySchema> properties) : properties_(properties) {
        LRAY_DCHECK(properties.size() <= kMaxProperties);
        for (std::size_t i = 0; i < properties.size(); ++i) new (&values_[i]) Value;
    }
    PropertyValues(const PropertyValues& other) : properties_(other.properties_) {
        for (std::size_t i = 0; i < properties_.size(); ++i) {
            new (&values_[i]) Value(other.values_[i]);
        }
    }
    PropertyValues& operator=(const PropertyValues& other) {
        properties_ = other.properties_;
        for (std::size_t i = 0; i < properties_.size(); ++i) {
            new (&values_[i]) Value(other.values_[i]);
        }
        return *this;
    }
    ~PropertyValues() = default;

    bool has(std::size_t slot) const { return values_[slot].kind != ValueKind::none; }
    void set(std::size_t slot, const Value& value) { values_[slot] = value; }
    const Value& operator[](std::size_t slot) const { return values_[slot]; }

    /// Shape: one for each property.
    std::span<const Value> all() const { return {values_, properties_.size()}; }

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
        return Color{linear + 0.0};  // -0 is 0
    }
    std::optional<Color> optional_color(std::size_t slot) const {
        if (!has(slot)) return std::nullopt;
        return color(slot);
    }
    /// The texture that stands in the place of a value; none: a value.
    scene::TextureId texture(std::size_t slot) const {
        const Value& value = values_[slot];
        return value.is(ValueKind::texture) ? scene::TextureId(value.made->id) : scene::TextureId{};
    }
    std::uint32_t integer(std::size_t slot) const {
        return static_cast<std::uint32_t>(number(slot));
    }
    /// Which of its options an `option` has: their order is that of an enum.
    template <class Enum>
    Enum option(std::size_t slot) const {
        const PropertySchema& property = properties_[slot];
        std::string_view quoted = property.default_text;
        const std::string_view chosen = string(slot, quoted.substr(1, quoted.size() - 2));
        std::size_t index = 0;
        while (index < property.options.size() && property.options[index] != chosen) ++index;
        LRAY_ASSERT(index < property.options.size());
        return static_cast<Enum>(index);
    }
    std::string_view string(std::size_t slot, std::string_view fallback) const {
        const Value& value = values_[slot];
        return value.is(ValueKind::string) ? value.string() : fallback;
    }

 private:
    std::span<const PropertySchema> properties_;
    union {  // only those of the schema are made: literal shapes come by the million
        Value values_[kMaxProperties];
    };
};
static_assert(std::is_trivially_copyable_v<Value>);

}  // namespace lray::parser
