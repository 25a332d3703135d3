// Which values a property takes.
#pragma once

#include "base/diagnostics.h"
#include "parser/blocks/property_values.h"
#include "parser/blocks/schema.h"
#include "parser/syntax/ast.h"
#include "parser/values/value.h"

namespace lray::parser {

/// True if the numbers of a value, which has the property's type, lie in its range.
bool is_in_range(const PropertySchema& property, const Value& value);

/// True if all required properties are set, and none of two forms that exclude each other.
bool is_complete(std::span<const PropertySchema> properties, const PropertyValues& values);

/// Returns the value as the property's type wants it: poison when it does not fit.
/// Errors: E0301 type, E0303 size, E0304 range, E0308 not whole, E0309 colour as point, E0310
/// scale 0, E0403 unknown option; warns W1403 of colours that look like 0 to 255. All at `span`.
/// Poison stays poison, in silence.
/// `name` is what the value is called where it is a plain name, for messages.
Value fit(const PropertySchema& property, const Value& value, Span span, Diagnostics& diagnostics,
          std::string_view name = {});

/// Returns the name that an expression consists of; empty if it is anything else.
std::string_view name_of(const Expr& expr, const Sources& sources);

}  // namespace lray::parser
