#include "parser/blocks/property_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/did_you_mean.h"
#include "parser/blocks/stops.h"
#include "parser/values/operators.h"

namespace lray::parser {

namespace {

/// The numbers of a value of a numeric type.
std::span<const double> numbers_of(const Value& value) {
    if (value.is(ValueKind::number)) return {&value.number, 1};
    if (value.is(ValueKind::numbers)) return {value.numbers, value.count};
    if (value.is(ValueKind::color)) return {value.numbers, 3};
    if (value.is(ValueKind::rows)) return {value.numbers, std::size_t{value.count} * value.width};
    return {};
}

bool is_whole(double number) {
    return number == std::floor(number) && std::fabs(number) <= 9007199254740992.0;  // 2^53
}

std::string range_in_words(const Range& range) {
    if (range.max == kAnyNumber.max) {
        if (range.min_is_open) return fmt::format("greater than {}", format_number(range.min));
        return range.min == 0.0 ? "0 or greater"
                                : fmt::format("{} or greater", format_number(range.min));
    }
    if (range.min_is_open) {
        return fmt::format("greater than {} and at most {}", format_number(range.min),
                           format_number(range.max));
    }
    return fmt::format("from {} to {}", format_number(range.min), format_number(range.max));
}

/// A value that is fitted to a property; remembers whether it was reported.
class Fitting {
 public:
    Fitting(const PropertySchema& property, const Value& value, Span span, Diagnostics& diagnostics,
            std::string_view name)
        : property_(property), value_(value), span_(span), diagnostics_(diagnostics), name_(name) {}

    Value fit();

 private:
    Value error(Code code, std::string message, std::string help = {}) {
        Diagnostic& diagnostic = diagnostics_.error(code, span_, std::move(message));
        if (!help.empty()) diagnostic.with_help(std::move(help));
        return Value::poison();
    }
    Value wrong_type(std::string_view wanted) {
        return error(Code::E0301, fmt::format("`{}` needs {}, {} is {}", property_.name, wanted,
                                              value_name(), describe(value_)));
    }
    std::string value_name() const { return name_.empty() ? "this" : fmt::format("`{}`", name_); }
    Value out_of_range(double number) {
        return error(Code::E0304,
                     fmt::format("`{}` must be {}, this is {}", property_.name,
                                 range_in_words(property_.range), format_number(number)));
    }

    Value number();
    Value integer();
    Value vector(std::uint32_t size, std::string_view wanted);
    Value direction();
    Value color();
    Value scale();
    Value option();
    Value matrix();
    Value transform();
    Value rows(std::uint8_t width, std::string_view wanted, bool is_whole_wanted);
    Value colors();
    Value height_rows();
    Value stops();
    Value focus();
    Value ranged(const Value& value);

    const PropertySchema& property_;
    const Value& value_;
    Span span_;
    Diagnostics& diagnostics_;
    std::string_view name_;
};

Value Fitting::ranged(const Value& value) {
    for (const double number : numbers_of(value)) {
        if (!property_.range.contains(number)) return out_of_range(number);
    }
    return value;
}

Value Fitting::number() {
    if (!value_.is(ValueKind::number)) return wrong_type("a number");
    return ranged(value_);
}

Value Fitting::integer() {
    if (!value_.is(ValueKind::number)) return wrong_type("a whole number");
    if (!is_whole(value_.number)) {
        return error(Code::E0308, fmt::format("`{}` needs a whole number, this is {}",
                                              property_.name, format_number(value_.number)));
    }
    return ranged(value_);
}

Value Fitting::vector(std::uint32_t size, std::string_view wanted) {
    if (value_.is(ValueKind::color)) {
        return error(Code::E0309, fmt::format("`{}` needs {}, {} is a colour", property_.name,
                                              wanted, value_name()));
    }
    if (value_.is(ValueKind::numbers) && value_.count != size) {
        return error(Code::E0303, fmt::format("`{}` needs {} numbers, this has {}", property_.name,
                                              size, value_.count));
    }
    if (!value_.is(ValueKind::numbers)) {
        return wrong_type(fmt::format("{}, like {}", wanted, size == 2 ? "[1, 2]" : "[1, 2, 3]"));
    }
    return ranged(value_);
}

Value Fitting::direction() {
    const Value fitted = vector(3, "a direction");
    if (fitted.is(ValueKind::poison)) return fitted;
    if (fitted.vec3() == DVec3{0.0}) {
        return error(Code::E0304, fmt::format("`{}` must not be [0, 0, 0]: it has no direction",
                                              property_.name));
    }
    return fitted;
}

Value Fitting::color() {
    const bool is_color =
        value_.is(ValueKind::color) || value_.is(ValueKind::number) || value_.is_vector(3);
    if (!is_color) {
        if (value_.is(ValueKind::numbers)) {
            return error(Code::E0303, fmt::format("`{}` needs 3 numbers, this has {}",
                                                  property_.name, value_.count));
        }
        return wrong_type(property_.takes_texture ? "a colour or a texture" : "a colour");
    }
    const std::span<const double> numbers = numbers_of(value_);
    const bool looks_like_bytes =
        value_.is(ValueKind::numbers) && property_.name != "emission" &&
        std::all_of(numbers.begin(), numbers.end(),
                    [](double n) { return is_whole(n) && n >= 0.0 && n <= 255.0; }) &&
        std::any_of(numbers.begin(), numbers.end(), [](double n) { return n > 1.0; });
    if (looks_like_bytes) {
        diagnostics_.warning(Code::W1403, span_,
                             fmt::format("colours run 0 to 1; write `#{:02x}{:02x}{:02x}`",
                                         static_cast<int>(numbers[0]), static_cast<int>(numbers[1]),
                                         static_cast<int>(numbers[2])));
    }
    return ranged(value_);
}

Value Fitting::scale() {
    if (value_.is(ValueKind::number)) {
        if (value_.number != 0.0) return value_;
        return error(Code::E0310, "a scale of 0 cannot be inverted");
    }
    const Value fitted = vector(3, "a number or three");
    if (fitted.is(ValueKind::poison)) return fitted;
    for (const double factor : numbers_of(fitted)) {
        if (factor != 0.0) continue;
        return error(Code::E0310,
                     "a scale of 0 cannot be inverted; for a flat shape use rectangle");
    }
    return fitted;
}

Value Fitting::option() {
    if (!value_.is(ValueKind::string)) return wrong_type("a string");
    const std::string_view text = value_.string();
    const std::span<const std::string_view> options = property_.options;
    if (std::find(options.begin(), options.end(), text) != options.end()) return value_;
    std::string help = "there are:";
    for (const std::string_view known : options) help += fmt::format(" \"{}\"", known);
    const std::string near = did_you_mean(text, options);
    return error(Code::E0403,
                 near.empty() ? fmt::format("unknown {} `{}`", property_.name, text)
                              : fmt::format("unknown {} `{}`; {}", property_.name, text, near),
                 std::move(help));
}

Value Fitting::matrix() {
    const bool fits =
        value_.is(ValueKind::rows) && value_.width == 4 && (value_.count == 3 || value_.count == 4);
    if (!fits) return wrong_type("3 or 4 rows of 4 numbers");
    if (value_.count == 4) {
        const double* last = value_.numbers + 12;
        if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0) {
            return error(Code::E0304, "the last row of a matrix must be [0, 0, 0, 1]");
        }
    }
    return value_;
}

Value Fitting::transform() {
    if (value_.is(ValueKind::transform)) return value_;
    if (!value_.is(ValueKind::list)) return wrong_type("a transform, like translation([1, 0, 0])");
    for (std::uint32_t i = 0; i < value_.count; ++i) {
        const Value& step = value_.elements[i];
        if (step.is(ValueKind::poison)) return Value::poison();
        if (step.is(ValueKind::transform)) continue;
        return error(Code::E0301, fmt::format("`{}` needs a list of transforms; element {} is {}",
                                              property_.name, i, describe(step)));
    }
    return value_;
}

Value Fitting::rows(std::uint8_t width, std::string_view wanted, bool is_whole_wanted) {
    if (value_.is(ValueKind::list) && value_.count == 0) return value_;
    if (value_.is(ValueKind::rows) && value_.width != width) {
        return error(Code::E0303, fmt::format("`{}` needs rows of {} numbers, these have {}",
                                              property_.name, width, value_.width));
    }
    if (!value_.is(ValueKind::rows)) return wrong_type(wanted);
    const std::span<const double> numbers = numbers_of(value_);
    for (std::size_t i = 0; is_whole_wanted && i < numbers.size(); ++i) {
        if (is_whole(numbers[i]) && numbers[i] >= 0.0) continue;
        return error(Code::E0308,
                     fmt::format("`{}` needs whole numbers from 0, row {} has {}", property_.name,
                                 i / width, format_number(numbers[i])));
    }
    return value_;
}

// [red, #00ff00, [0, 0, 1], 0.5]
Value Fitting::colors() {
    constexpr std::string_view kWanted = "a list of colours, like [red, #00ff00]";
    if (!value_.is_list()) return wrong_type(kWanted);
    for (std::uint32_t i = 0; i < value_.count; ++i) {
        const Value color = element(value_, i);
        if (color.is(ValueKind::poison)) return color;
        if (!color.is(ValueKind::color) && !color.is(ValueKind::number) && !color.is_vector(3)) {
            return error(Code::E0301, fmt::format("`{}` needs {}; element {} is {}", property_.name,
                                                  kWanted, i, describe(color)));
        }
        for (const double number : numbers_of(color)) {
            if (property_.range.contains(number)) continue;
            return error(Code::E0304,
                         fmt::format("`{}` must be {}, element {} has {}", property_.name,
                                     range_in_words(property_.range), i, format_number(number)));
        }
    }
    return value_;
}

Value Fitting::height_rows() {
    constexpr std::string_view kWanted = "rows of numbers, like [[0, 1], [0, 2]]";
    if (!value_.is_list() || value_.is(ValueKind::numbers)) return wrong_type(kWanted);
    for (std::uint32_t i = 0; i < value_.count; ++i) {
        const Value row = element(value_, i);
        if (!row.is(ValueKind::numbers)) {
            return error(Code::E0301, fmt::format("`{}` needs {}; row {} is {}", property_.name,
                                                  kWanted, i, describe(row)));
        }
        if (row.count == element(value_, 0).count) continue;
        return error(Code::E0303, fmt::format("row {} of `{}` has {} numbers, row 0 has {}", i,
                                              property_.name, row.count, element(value_, 0).count));
    }
    if (value_.count >= 2 && element(value_, 0).count >= 2) return value_;
    return error(Code::E0303,
                 fmt::format("`{}` needs 2 rows of 2 numbers or more", property_.name));
}

// [[0, black], [0.5, 0.2], [1, [0, 0, 1]]]; how a stop is read is in stops.h.
Value Fitting::stops() {
    constexpr std::string_view kWanted = "a list of stops, like [[0, black], [1, white]]";
    const bool is_list = value_.is(ValueKind::list) || value_.is(ValueKind::rows);
    if (!is_list) return wrong_type(kWanted);
    if (value_.count < 2 || value_.count > kMaxStops) {
        return error(Code::E0303, fmt::format("`{}` needs 2 to {} stops, this has {}",
                                              property_.name, kMaxStops, value_.count));
    }
    double last = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < value_.count; ++i) {
        const Value stop = element(value_, i);
        if (stop.is(ValueKind::poison)) return stop;
        const std::optional<scene::ColorStop> read = read_stop(stop);
        if (!read) {
            return error(Code::E0301, fmt::format("`{}` needs stops of a place and a colour, like "
                                                  "[0.5, white]; stop {} is {}",
                                                  property_.name, i, describe(stop)));
        }
        if (!property_.range.contains(read->at)) return out_of_range(read->at);
        if (read->at < last) {
            return error(Code::E0304, fmt::format("`{}` must be in order; stop {} is at {}, behind "
                                                  "{}",
                                                  property_.name, i, format_number(read->at),
                                                  format_number(last)));
        }
        if (read->color.x < 0.0f || read->color.y < 0.0f || read->color.z < 0.0f) {
            return error(Code::E0304,
                         fmt::format("the colours of `{}` must be 0 or greater; that of stop {} "
                                     "is not",
                                     property_.name, i));
        }
        last = read->at;
    }
    return value_;
}

Value Fitting::focus() {
    if (value_.is(ValueKind::number)) return ranged(value_);
    if (value_.is_vector(3)) return value_;
    return vector(3, "a distance or a point");  // says what is wrong with it
}

Value Fitting::fit() {
    if (property_.takes_texture && value_.is(ValueKind::texture)) return value_;
    switch (property_.type) {
        case PropertyType::number:
        case PropertyType::angle:
            return number();
        case PropertyType::integer:
            return integer();
        case PropertyType::boolean:
            return value_.is(ValueKind::boolean) ? value_ : wrong_type("true or false");
        case PropertyType::string:
            return value_.is(ValueKind::string) ? value_ : wrong_type("a string");
        case PropertyType::option:
            return option();
        case PropertyType::point:
            return vector(3, "a point");
        case PropertyType::direction:
            return direction();
        case PropertyType::vec2:
            return vector(2, "two numbers");
        case PropertyType::size2:
            return vector(2, "two numbers");
        case PropertyType::size3:
            return vector(3, "three numbers");
        case PropertyType::color:
            return color();
        case PropertyType::scale:
            return scale();
        case PropertyType::rotation:
            return value_.is(ValueKind::transform) ? value_ : vector(3, "three angles");
        case PropertyType::matrix:
            return matrix();
        case PropertyType::transform:
            return transform();
        case PropertyType::material:
            return value_.is(ValueKind::material) ? value_ : wrong_type("a material");
        case PropertyType::roughness:
            if (value_.is(ValueKind::number)) return ranged(value_);
            return vector(2, "one or two numbers");
        case PropertyType::resolution: {
            const Value fitted = vector(2, "width and height");
            if (fitted.is(ValueKind::poison)) return fitted;
            for (const double number : numbers_of(fitted)) {
                if (is_whole(number)) continue;
                return error(Code::E0308, fmt::format("`{}` needs whole numbers, this has {}",
                                                      property_.name, format_number(number)));
            }
            return fitted;
        }
        case PropertyType::file:
            return value_.is(ValueKind::string)
                       ? value_
                       : wrong_type(property_.takes_texture ? "a file name or a texture"
                                                            : "a file name");
        case PropertyType::points:
            return rows(3, "a list of points, like [[0, 0, 0], [1, 0, 0]]", false);
        case PropertyType::colors:
            return colors();
        case PropertyType::uvs:
            return rows(2, "a list of pairs, like [[0, 0], [1, 0]]", false);
        case PropertyType::index_triples:
            return rows(3, "a list of triples, like [[0, 1, 2]]", true);
        case PropertyType::any:
            return value_;
        case PropertyType::function:
            return value_.is(ValueKind::function) ? value_ : wrong_type("a function");
        case PropertyType::height_rows:
            return height_rows();
        case PropertyType::texture:
            return value_.is(ValueKind::texture) ? value_ : wrong_type("a texture");
        case PropertyType::stops:
            return stops();
        case PropertyType::focus:
            return focus();
    }
    LRAY_ASSERT(false);
}

}  // namespace

bool is_in_range(const PropertySchema& property, const Value& value) {
    bool is_zero = true;
    for (const double number : numbers_of(value)) {
        if (!property.range.contains(number)) return false;
        is_zero = is_zero && number == 0.0;
    }
    return !(property.type == PropertyType::direction && is_zero);
}

bool is_complete(std::span<const PropertySchema> properties, const PropertyValues& values) {
    Form form = Form::any;
    for (std::size_t slot = 0; slot < properties.size(); ++slot) {
        const Form of_slot = properties[slot].form;
        if (!values.has(slot) || of_slot == Form::any) continue;
        if (form != Form::any && form != of_slot) return false;
        form = of_slot;
    }
    for (std::size_t slot = 0; slot < properties.size(); ++slot) {
        if (is_needed(properties[slot], form) && !values.has(slot)) return false;
    }
    return true;
}

Value fit(const PropertySchema& property, const Value& value, Span span, Diagnostics& diagnostics,
          std::string_view name) {
    if (value.is(ValueKind::poison)) return value;
    return Fitting(property, value, span, diagnostics, name).fit();
}

std::string_view name_of(const Expr& expr, const Sources& sources) {
    return expr.kind == ExprKind::name ? sources.text(expr.span) : std::string_view{};
}

}  // namespace lray::parser
