#include "preset/schema_parts.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "preset/json.h"

namespace frond {
namespace {

Value& bound(Value& schema, const Range& range) {
  if (std::isfinite(range.min))
    schema.set(range.above_min ? "exclusiveMinimum" : "minimum", make_number(range.min));
  if (std::isfinite(range.max)) schema.set("maximum", make_number(range.max));
  return schema;
}

Value fewest_digits(const char* begin, const char* end) {
  double number = 0;
  std::from_chars(begin, end, number);
  return make_number(number);
}

Value strip_notes(Value schema) {
  schema.remove("description");
  schema.remove("default");
  if (Value* properties = schema.find("properties")) {
    for (Member& member : properties->members) member.value = strip_notes(std::move(member.value));
  }
  return schema;
}

void append_paths(std::vector<std::string>& paths, const std::string& above, const Value& schema) {
  const Value* properties = schema.find("properties");
  if (!properties) return;
  for (const Member& member : properties->members) {
    paths.push_back(above + member.name);
    append_paths(paths, above + member.name + "/", member.value);
  }
}

}  // namespace

Value typed(std::string_view type) { return make_object().set("type", make_text(type)); }

Value number_schema(const Range& range) {
  Value schema = typed("number");
  return bound(schema, range);
}

Value integer_schema(const Range& range) {
  Value schema = typed("integer");
  return bound(schema, range);
}

Value vector_schema(const Value& component, std::size_t length) {
  return list_schema(component, {.min = length, .max = length});
}

Value direction_schema(Across across) {
  Value zero = make_object().set("const", make_number(0));
  Value any = make_object();
  Value nowhere = make_list({zero, across == Across::all ? zero : any, zero});
  Value schema = vector_schema(number_schema(kDirections), 3);
  return schema.set("not", make_object().set("items", std::move(nowhere)));
}

Value color_schema() {
  Value text = typed("string");
  text.set("pattern", make_text(R"(^#([0-9a-fA-F]{3}){1,2}$|^(rgb|hsl)\(.+\)$|^[a-zA-Z]+$|^palette:.+$)"));
  Value rgb = vector_schema(number_schema(kShare), 3);
  return make_object().set("anyOf", make_list({text, rgb}));
}

Value curve_schema() { return list_schema(vector_schema(number_schema({}), 2), {.min = 2}); }

Value animated_schema(const Value& value, const Value& shape) {
  Value key = typed("array");
  key.set("items", make_list({number_schema({}), value, shape}));
  key.set("minItems", make_number(2)).set("maxItems", make_number(3));
  return make_object().set("anyOf", make_list({value, list_schema(key, {.min = 1})}));
}

Value list_schema(const Value& element, const Count& count) {
  Value schema = typed("array").set("items", element);
  if (count.min > 0) schema.set("minItems", make_number(static_cast<double>(count.min)));
  if (count.max != Count{}.max) schema.set("maxItems", make_number(static_cast<double>(count.max)));
  return schema;
}

Value pairs_schema() {
  std::array<std::string_view, 2> types{"number", "string"};
  return typed("object").set("additionalProperties", make_object().set("type", make_texts(types)));
}

Value choice_schema(std::span<const std::string_view> names) {
  return typed("string").set("enum", make_texts(names));
}

std::string with_choices(std::string_view doc, std::span<const std::string_view> names,
                         std::span<const std::string_view> docs) {
  std::string text(doc);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!docs[i].empty()) text += fmt::format("{}{}: {}", i == 0 ? ". " : "; ", names[i], docs[i]);
  }
  return text;
}

Value tidy_number(float number) {
  std::array<char, 32> text;
  return fewest_digits(text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr);
}

Value tidy_number(double number) { return make_number(number); }

Value tidy_angle(double angle) {
  std::string text = fmt::format("{:.6g}", degrees(angle));
  Value tidy = fewest_digits(text.data(), text.data() + text.size());
  if (std::abs(radians(tidy.number) - angle) <= 1e-7 * std::abs(angle)) return tidy;
  // Not a round one: that which is read as the same.
  double exact = degrees(angle);
  for (double near : {std::nextafter(exact, 0.0), std::nextafter(exact, 2 * exact)})
    if (radians(exact) != angle && radians(near) == angle) exact = near;
  return make_number(exact);
}

Value curve_default(const Curve& curve) {
  Value points = make_list();
  for (Vec2 p : curve.points()) points.items.push_back(make_list({tidy_number(p.x), tidy_number(p.y)}));
  return points;
}

Value color_default(const Color& color) {
  auto byte = [](float channel) { return static_cast<int>(std::lround(channel * 255.0f)); };
  return make_text(fmt::format("#{:02x}{:02x}{:02x}", byte(color.red), byte(color.green), byte(color.blue)));
}

Value without_required(Value schema) {
  schema.remove("required");
  if (Value* then = schema.find("then")) *then = without_required(std::move(*then));
  for (std::string_view several : {"allOf", "anyOf"})
    if (Value* all = schema.find(several))
      for (Value& inner : all->items) inner = without_required(std::move(inner));
  if (Value* properties = schema.find("properties")) {
    for (Member& member : properties->members) member.value = without_required(std::move(member.value));
  }
  return schema;
}

Value either(const Value& a, const Value& b) {
  if (serialize(strip_notes(a)) == serialize(strip_notes(b))) {
    Value same = a;
    same.remove("default");
    return same;
  }
  const Value* ours = a.find("properties");
  const Value* theirs = b.find("properties");
  if (ours && theirs && !a.find("allOf") && !b.find("allOf")) {
    Value joined = a;
    Value& properties = *joined.find("properties");
    for (const Member& member : theirs->members) {
      const Value* known = ours->find(member.name);
      properties.set(member.name, known ? either(*known, member.value) : member.value);
    }
    return joined;
  }
  Value choices = make_list();
  for (const Value* one : {&a, &b}) {
    if (const Value* any = one->find("anyOf"))
      choices.items.insert(choices.items.end(), any->items.begin(), any->items.end());
    else
      choices.items.push_back(strip_notes(*one));
  }
  return make_object().set("anyOf", choices);
}

std::vector<std::string> paths_of(const Value& object_schema) {
  std::vector<std::string> paths;
  append_paths(paths, "", object_schema);
  return paths;
}

}  // namespace frond
