#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve.h"
#include "core/vec.h"
#include "preset/describe.h"
#include "preset/value.h"

namespace frond {

// Schemas (JSON Schema draft-07) of single properties, for SchemaWriter.

/// A schema that says no more than a type.
Value typed(std::string_view type);
Value number_schema(const Range& range);
Value integer_schema(const Range& range);
Value vector_schema(const Value& component, std::size_t length);
Value direction_schema(Across across);
Value color_schema();
Value curve_schema();
/// A value or keyframes of it, and of what else these may say.
Value animated_schema(const Value& value, const Value& shape);
Value list_schema(const Value& element, const Count& count);
Value pairs_schema();
Value choice_schema(std::span<const std::string_view> names);
/// A doc that goes on with what each choice is.
std::string with_choices(std::string_view doc, std::span<const std::string_view> names,
                         std::span<const std::string_view> docs);

/// A number as a default: with the fewest digits that identify a float, or six digits.
Value tidy_number(float number);
Value tidy_number(double number);
Value tidy_angle(double radians);
Value curve_default(const Curve& curve);
Value color_default(const Color& color);

/// An object with defaults behind it requires nothing. Does not apply to elements of its lists.
Value without_required(Value schema);

/// The schema of a property that matches either of two; objects are merged member by member. Titles and
/// defaults that differ between kinds are omitted.
Value either(const Value& a, const Value& b);

/// The paths of all properties: "wave", "wave/amplitude", ...
std::vector<std::string> paths_of(const Value& object_schema);

}  // namespace frond
