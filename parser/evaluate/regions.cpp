#include "parser/evaluate/regions.h"

#include <array>
#include <cstring>
#include <vector>

#include "base/assert.h"
#include "parser/syntax/ast.h"

namespace lray::parser {

namespace {

/// True if a value is all in its 16 bytes, or in memory that is kept.
bool is_immediate(const Value& value) {
    switch (value.kind) {
        case ValueKind::none:
        case ValueKind::poison:
        case ValueKind::number:
        case ValueKind::boolean:
        case ValueKind::texture:
        case ValueKind::material:
        case ValueKind::node:
            return true;
        case ValueKind::string:
        case ValueKind::numbers:
        case ValueKind::rows:
        case ValueKind::list:
        case ValueKind::color:
        case ValueKind::transform:
        case ValueKind::record:
        case ValueKind::function:
            return false;
    }
    LRAY_ASSERT(false);
}

/// Bytes of a value's own contents, without what these refer to.
std::size_t shallow_size(const Value& value) {
    if (value.is(ValueKind::string)) return value.count;
    if (value.is(ValueKind::list)) return value.count * sizeof(Value);
    if (value.is(ValueKind::record)) return value.count * sizeof(RecordField);
    return sizeof(double) * value.count * std::max<std::size_t>(value.width, 1);
}

}  // namespace

Value ValueCopier::copy(const Value& value) {
    if (is_immediate(value)) return value;
    Value result = value;
    switch (value.kind) {
        case ValueKind::string:
            result.text = copied(value.text, value.count);
            return result;
        case ValueKind::numbers:
        case ValueKind::color:
            result.numbers = copied(value.numbers, value.count);
            return result;
        case ValueKind::rows:
            result.numbers = copied(value.numbers, std::size_t{value.count} * value.width);
            return result;
        case ValueKind::transform:
            result.transform = copied(value.transform, 1);
            return result;
        case ValueKind::list: {
            if (value.count == 0 || !from_.holds(value.elements, mark_)) return value;
            if (const auto known = shared_.find(value.elements); known != shared_.end()) {
                return known->second;
            }
            std::vector<Value> elements(value.elements, value.elements + value.count);
            for (Value& element : elements) element = copy(element);
            result.elements = to_.copy(elements).data();
            size_ += elements.size() * sizeof(Value);
            shared_.emplace(value.elements, result);
            return result;
        }
        case ValueKind::record: {
            if (value.count == 0 || !from_.holds(value.fields, mark_)) return value;
            if (const auto known = shared_.find(value.fields); known != shared_.end()) {
                return known->second;
            }
            std::vector<RecordField> fields(value.fields, value.fields + value.count);
            for (RecordField& field : fields) field.value = copy(field.value);
            result.fields = to_.copy(fields).data();
            size_ += fields.size() * sizeof(RecordField);
            shared_.emplace(value.fields, result);
            return result;
        }
        case ValueKind::function: {
            if (!from_.holds(value.function, mark_)) return value;
            if (const auto known = shared_.find(value.function); known != shared_.end()) {
                return known->second;
            }
            FunctionValue function = *value.function;
            const std::size_t count =
                function.function == nullptr ? 0 : function.function->capture_slots.size();
            std::vector<Value> captures(function.captures, function.captures + count);
            for (Value& captured : captures) captured = copy(captured);
            function.captures = to_.copy(captures).data();
            result.function = to_.make<FunctionValue>(function);
            size_ += sizeof(FunctionValue) + count * sizeof(Value);
            shared_.emplace(value.function, result);
            return result;
        }
        case ValueKind::none:
        case ValueKind::poison:
        case ValueKind::number:
        case ValueKind::boolean:
        case ValueKind::texture:
        case ValueKind::material:
        case ValueKind::node:
            break;
    }
    LRAY_ASSERT(false);
}

// What is made later is never part of what was made before.
bool ValueMemory::is_made_since(const Region& region, const Value& value) const {
    return !is_immediate(value) && arena_.holds(value.pointer(), region.mark);
}

void ValueMemory::end(const Region& region) {
    arena_.reset(region.mark);
    const std::uint64_t kept = budget_.kept_bytes - region.kept_bytes;
    if (!budget_.is_spent) budget_.value_bytes = region.value_bytes - kept;
}

Value ValueMemory::end_with(const Region& region, const Value& result) {
    if (is_immediate(result)) {
        end(region);
        return result;
    }
    // A vector or colour goes by the stack.
    constexpr std::size_t kFew = 8;
    const bool is_few = (result.is(ValueKind::numbers) || result.is(ValueKind::color)) &&
                        result.count <= kFew && result.count > 0;
    if (is_few && arena_.holds(result.numbers, region.mark)) {
        std::array<double, kFew> numbers;
        std::memcpy(numbers.data(), result.numbers, result.count * sizeof(double));
        end(region);
        Value moved = result;
        moved.numbers = arena_.copy(std::span<const double>(numbers.data(), result.count)).data();
        budget_.value_bytes -=
            std::min<std::uint64_t>(budget_.value_bytes, result.count * sizeof(double));
        return moved;
    }
    // What is returned through many calls must not be copied by each of them.
    const bool is_known = last_result_ == result.pointer();
    const std::size_t in_use = is_known ? last_result_size_ : shallow_size(result);
    if (!is_worth_copying(region, in_use)) return result;
    Value moved = result;
    last_result_size_ = end_with_values(region, [&](auto visit) { visit(moved); });
    last_result_ = moved.pointer();
    return moved;
}

}  // namespace lray::parser
