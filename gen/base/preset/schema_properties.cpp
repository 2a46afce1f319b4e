#include <cassert>

#include "core/assets.h"
#include "preset/eases.h"
#include "preset/schema.h"
#include "preset/schema_parts.h"

// The properties that SchemaWriter describes, see describe.h.

namespace frond {

namespace {

Range whole_range(Range range, const SlotType& type) {
  if (type.is_unsigned && range.min < 0) range.min = 0, range.above_min = false;
  return range;
}

std::string_view angle_unit(const Range& range) { return range.unit.empty() ? "degrees" : range.unit; }

Value tidy_real(Slot x) {
  return x.type->is_float ? tidy_number(x.as<float>()) : tidy_number(x.as<double>());
}

template <class Real>
Value tidy_all(const Real* parts, int count) {
  Value list = make_list();
  for (int i = 0; i < count; ++i) list.items.push_back(tidy_number(parts[i]));
  return list;
}

Value tidy_vector(Slot v) {
  return v.type->is_float ? tidy_all(&v.as<float>(), v.type->length)
                          : tidy_all(&v.as<double>(), v.type->length);
}

Value tidy_key(double x) { return tidy_number(x); }
Value tidy_key(Vec3 x) { return tidy_all(&x.x, 3); }

template <class T>
Value animated_default(const Animated<T>& a) {
  if (a.constant()) return tidy_key(a.keys()[0].value);
  Value keys = make_list();
  for (const auto& key : a.keys())
    keys.items.push_back(make_list({make_number(key.time), tidy_key(key.value)}));
  return keys;
}

Value default_of(Slot x) {
  switch (x.type->kind) {
    case SlotType::Kind::boolean:
      return make_boolean(x.as<bool>());
    case SlotType::Kind::real:
      return tidy_real(x);
    case SlotType::Kind::integer:
      return make_number(x.type->get(x.at));
    case SlotType::Kind::text:
      return make_text(x.as<std::string>());
    case SlotType::Kind::vector:
      return tidy_vector(x);
    case SlotType::Kind::size:
      return make_list(
          {make_number(x.as<std::array<int, 2>>()[0]), make_number(x.as<std::array<int, 2>>()[1])});
    case SlotType::Kind::color:
      return color_default(x.as<Color>());
    case SlotType::Kind::curve:
      return curve_default(x.as<Curve>());
    case SlotType::Kind::animated:
      return x.type->length == 1 ? animated_default(x.as<Animated<double>>())
                                 : animated_default(x.as<Animated<Vec3>>());
    default:
      return {};
  }
}

/// The default of a property, null where it has none.
template <class Print>
Value initial(Slot x, Print print) {
  std::optional<Slot> held = x.held();
  return held ? print(*held) : Value{};
}

Value written_schema(std::string_view json) {
  Result<Document> schema = parse_json(json, "schema");
  assert(schema.ok() && "the schema of a custom property is no JSON");
  return schema ? schema->root : make_object();
}

}  // namespace

Value SchemaWriter::value_schema(const SlotType& type, const Range& range) {
  auto numbers = [&] { return vector_schema(number_schema(range), static_cast<std::size_t>(type.length)); };
  switch (type.kind) {
    case SlotType::Kind::boolean:
      return typed("boolean");
    case SlotType::Kind::real:
      return number_schema(range);
    case SlotType::Kind::integer:
      return integer_schema(whole_range(range, type));
    case SlotType::Kind::text:
      return typed("string");
    case SlotType::Kind::vector:
      return numbers();
    case SlotType::Kind::size:
      return vector_schema(integer_schema(range), 2);
    case SlotType::Kind::color:
      return color_schema();
    case SlotType::Kind::curve:
      return curve_schema();
    case SlotType::Kind::animated:
      return type.length == 1 ? animated_schema(number_schema(range), of<KeyShape<double>>())
                              : animated_schema(numbers(), of<KeyShape<Vec3>>());
    case SlotType::Kind::pairs:
      return pairs_schema();
    default:
      return sample_schema(type);
  }
}

void SchemaWriter::visit_value(std::string_view name, Slot x, const Range& range, std::string_view doc) {
  bool object = x.type->kind == SlotType::Kind::object;  // which is shown as it is
  add(name, object ? schema_of(x) : value_schema(x.held_type(), range), doc, range.unit,
      initial(x, default_of));
}

void SchemaWriter::angle(std::string_view name, RealSlot x, const Range& range, std::string_view doc) {
  add(name, number_schema(range), doc, angle_unit(range), initial(x, [](Slot held) {
        return tidy_angle(held.type->is_float ? static_cast<double>(held.as<float>()) : held.as<double>());
      }));
}

void SchemaWriter::file(std::string_view name, FileName& file, LoadFile, std::string_view doc, bool) {
  text(name, file.name, doc);
}

void SchemaWriter::choose(std::string_view name, Slot e, const ChoiceTable& table, std::string_view doc) {
  std::vector<std::string_view> names = table.names(), docs;
  for (std::size_t i = 0; i < table.size(); ++i) docs.push_back(table.doc(i));
  add(name, choice_schema(names), with_choices(doc, names, docs), "", initial(e, [&](Slot held) {
        std::string_view chosen = table.name_of(held);
        return chosen.empty() ? Value{} : make_text(chosen);
      }));
}

void SchemaWriter::direction(std::string_view name, VectorSlot v, Across across, std::string_view doc) {
  add(name, direction_schema(across), doc, "", initial(v, tidy_vector));
}

void SchemaWriter::list(std::string_view name, ListSlot l, const Count& count, std::string_view doc) {
  add(name, list_schema(value_schema(*l.held_type().element, {}), count), doc);
}

void SchemaWriter::visit_tagged(std::string_view name, Slot x, const KindTable& kinds, std::string_view doc) {
  const SlotType& type = x.held_type();
  bool list = type.kind == SlotType::Kind::list;
  add(name, list ? list_schema(tagged_schema(*type.element, kinds), {}) : tagged_schema(type, kinds), doc);
}

void SchemaWriter::inheriting_list(const Inheritance& names, ListSlot l, const KindTable& kinds,
                                   std::string_view doc) {
  const SlotType& one = *l.held_type().element;
  Value all = defaults_of(one, kinds);
  add(names.force, list_schema(make_object().set("enum", make_texts(paths_of(all))), {}),
      "Properties that all organisms take from the defaults, whatever their own value");
  add(names.defaults, std::move(all), "Properties of all organisms that do not give their own");
  Value element = without_required(tagged_schema(one, kinds));
  auto has = [](std::string_view name) {
    return make_object().set("required", make_list({make_text(name)}));
  };
  element.remove("required");
  element.set("anyOf", make_list({has("kind"), has(names.instead)}));
  add(names.list, list_schema(element, {}), doc);
}

void SchemaWriter::read_custom(std::string_view name, Slot, ReadCustom, std::string_view schema,
                               std::string_view doc) {
  add(name, written_schema(schema), doc);
}

}  // namespace frond
