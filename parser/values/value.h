// The values of the language: 16 bytes each, immutable, what they point to lives in an Arena.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/source.h"
#include "base/transform.h"
#include "base/vec.h"
#include "parser/symbols.h"
#include "scene/ids.h"

namespace lray::parser {

struct BlockSchema;
struct Function;
struct RecordField;
struct FunctionValue;
struct Value;

enum class ValueKind : std::uint8_t {
    none,    // absent: a property that is not set. Never the value of an expression
    poison,  // an error was reported; uses of it are silent
    number,
    boolean,
    string,
    numbers,  // a list of numbers; 2 to 4 of them are a vector
    rows,     // a list of lists of numbers, all of one width
    list,     // any other list
    color,
    transform,
    texture,
    material,
    node,
    record,
    function,
};

/// A texture, material or node together with what it was made of, so that a copy with other
/// properties can be made.
struct Made {
    const BlockSchema* schema = nullptr;
    const Value* values = nullptr;  // one for each property of the schema
    std::uint32_t id = 0;           // TextureId, MaterialId or NodeId

    // Of a component
    const FunctionValue* component = nullptr;
    scene::NodeId children{};  // what was put between its braces; none: nothing
};

/// Lists, records and captured values are nested at most so deep, so passes over them may recurse.
inline constexpr std::uint8_t kMaxValueDepth = 200;

struct Value {
    ValueKind kind = ValueKind::none;
    std::uint8_t width = 0;       // of rows; of lists, records and functions: how deep they nest
    SourceId source = kNoSource;  // of a string: the file it was written in
    std::uint32_t count = 0;      // elements, rows, fields or bytes
    union {
        double number;
        bool boolean;
        const char* text;
        const double* numbers;  // of numbers, rows and a colour's linear RGBA
        const Value* elements;
        const Transform* transform;
        const Made* made;
        const RecordField* fields;
        const FunctionValue* function;
    };

    constexpr Value() : number(0.0) {}

    static constexpr Value poison() {
        Value value;
        value.kind = ValueKind::poison;
        return value;
    }
    static constexpr Value of(double number) {
        Value value;
        value.kind = ValueKind::number;
        value.number = number;
        return value;
    }
    static constexpr Value of(bool boolean) {
        Value value;
        value.kind = ValueKind::boolean;
        value.boolean = boolean;
        return value;
    }
    static constexpr Value of_numbers(std::span<const double> numbers) {
        Value value;
        value.kind = ValueKind::numbers;
        value.count = static_cast<std::uint32_t>(numbers.size());
        value.numbers = numbers.data();
        return value;
    }
    /// Shape: four numbers, linear RGBA.
    static constexpr Value of_color(const double* rgba) {
        Value value;
        value.kind = ValueKind::color;
        value.count = 4;
        value.numbers = rgba;
        return value;
    }
    static constexpr Value of_string(std::string_view text, SourceId source) {
        Value value;
        value.kind = ValueKind::string;
        value.source = source;
        value.count = static_cast<std::uint32_t>(text.size());
        value.text = text.data();
        return value;
    }
    static constexpr Value of_transform(const Transform* transform) {
        Value value;
        value.kind = ValueKind::transform;
        value.transform = transform;
        return value;
    }
    static constexpr Value of_made(ValueKind kind, const Made* made) {
        Value value;
        value.kind = kind;
        value.made = made;
        return value;
    }

    static constexpr Value of_record(std::span<const RecordField> fields, std::uint8_t depth);
    static constexpr Value of_function(const FunctionValue* function, std::uint8_t depth) {
        Value value;
        value.kind = ValueKind::function;
        value.width = depth;
        value.function = function;
        return value;
    }

    /// How deep a list, record or function nests; 0 of everything else.
    constexpr std::uint8_t depth() const {
        const bool nests =
            kind == ValueKind::list || kind == ValueKind::record || kind == ValueKind::function;
        return nests ? width : std::uint8_t{0};
    }
    constexpr bool is(ValueKind wanted) const { return kind == wanted; }
    constexpr bool is_list() const {
        return kind == ValueKind::numbers || kind == ValueKind::rows || kind == ValueKind::list;
    }
    constexpr bool is_vector(std::uint32_t size) const {
        return kind == ValueKind::numbers && count == size;
    }
    std::string_view string() const { return {text, count}; }
    /// Of everything but numbers and booleans: where its contents are.
    const void* pointer() const { return text; }
    DVec3 vec3() const { return {numbers[0], numbers[1], numbers[2]}; }
};
static_assert(sizeof(Value) == 16);

/// Fields keep the order in which they were written.
struct RecordField {
    Symbol name = kNoSymbol;
    Value value{};
};

/// A function as a value: of the scene, with what it captures, or a built-in one.
struct FunctionValue {
    const Function* function = nullptr;  // null: built in
    std::uint32_t builtin = 0;
    const Value* captures = nullptr;  // Function::capture_count of them
};

constexpr Value Value::of_record(std::span<const RecordField> fields, std::uint8_t depth) {
    Value value;
    value.kind = ValueKind::record;
    value.width = depth;
    value.count = static_cast<std::uint32_t>(fields.size());
    value.fields = fields.data();
    return value;
}

/// Returns what a value is, in words: "a number", "a list of 2 numbers", "a colour".
std::string describe(const Value& value);

/// Returns a number in its shortest exact form.
std::string format_number(double number);

}  // namespace lray::parser
