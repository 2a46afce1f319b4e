#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/assets.h"
#include "core/curve.h"
#include "core/vec.h"
#include "preset/describe.h"
#include "preset/eases.h"
#include "preset/json.h"
#include "preset/schema_parts.h"

namespace frond {

/// The visitor that makes the JSON Schema (draft-07) of described structs (describe.h). It expresses all
/// checks of Reader except the order of keyframes. Use schema_text() below.
class SchemaWriter {
 public:
  /// The schema of a described struct.
  template <class T>
  static Value of() {
    SchemaWriter writer;
    T sample{};
    describe(writer, sample);
    return writer.object_schema();
  }

  /// The schema of the defaults behind a list of these kinds: properties of any kind, none required.
  template <class T, class Kinds>
  static Value defaults_of(const Kinds& kinds);

  // The properties, see describe.h.

  template <class T>
  void number(std::string_view name, const T& x, const Range& range, std::string_view doc) {
    add(name, number_schema(range), doc, range.unit, initial(x, [](auto v) { return tidy_number(v); }));
  }
  template <class T>
  void angle(std::string_view name, const T& x, const Range& range, std::string_view doc) {
    add(name, number_schema(range), doc, angle_unit(range), initial(x, [](auto v) { return tidy_angle(v); }));
  }
  template <class T>
  void integer(std::string_view name, const T& n, const Range& range, std::string_view doc) {
    add(name, integer_schema(whole_range<Held<T>>(range)), doc, range.unit,
        initial(n, [](auto v) { return make_number(static_cast<double>(v)); }));
  }
  template <class T>
  void boolean(std::string_view name, const T& b, std::string_view doc) {
    add(name, type("boolean"), doc, "", initial(b, [](bool v) { return make_boolean(v); }));
  }
  template <class T>
  void text(std::string_view name, const T& s, std::string_view doc) {
    add(name, type("string"), doc, "", initial(s, [](const std::string& v) { return make_text(v); }));
  }
  template <class Load>
  void file(std::string_view name, const FileName& file, const Load&, std::string_view doc, bool = true) {
    text(name, file.name, doc);
  }
  template <class T, class Table>
  void choice(std::string_view name, const T& e, const Table& table, std::string_view doc) {
    std::vector<std::string_view> names;
    std::vector<std::string_view> docs;
    for (const auto& row : table) names.push_back(row.name), docs.push_back(row.doc);
    add(name, choice_schema(names), with_choices(doc, names, docs), "", initial(e, [&](auto v) {
          Value value;
          for (const auto& row : table) {
            if (row.value == v) value = make_text(row.name);
          }
          return value;
        }));
  }
  template <class T>
  void vector(std::string_view name, const T& v, const Range& range, std::string_view doc) {
    add(name, vector_schema(number_schema(range), Held<T>::length()), doc, range.unit,
        initial(v, &vector_default<Held<T>>));
  }
  template <class T>
  void vector(std::string_view name, const T& v, std::string_view doc) {
    vector(name, v, Range{}, doc);
  }
  template <class T>
  void direction(std::string_view name, const T& v, Across across, std::string_view doc) {
    add(name, direction_schema(across), doc, "", initial(v, &vector_default<Held<T>>));
  }
  template <class T>
  void direction(std::string_view name, const T& v, std::string_view doc) {
    direction(name, v, Across::all, doc);
  }
  template <class T>
  void size(std::string_view name, const T& s, const Range& range, std::string_view doc) {
    add(name, vector_schema(integer_schema(whole_range<int>(range)), 2), doc, range.unit,
        initial(s, [](const std::array<int, 2>& v) {
          return make_list({make_number(v[0]), make_number(v[1])});
        }));
  }
  template <class T>
  void color(std::string_view name, const T& c, std::string_view doc) {
    add(name, color_schema(), doc, "", initial(c, &color_default));
  }
  template <class T>
  void curve(std::string_view name, const T& c, std::string_view doc) {
    add(name, curve_schema(), doc, "", initial(c, &curve_default));
  }
  template <class T>
  void animated(std::string_view name, const T& a, const Range& range, std::string_view doc) {
    add(name, animated_schema(key_schema(range, Held<T>{}), key_shape(Held<T>{})), doc, range.unit,
        initial(a, [](const auto& v) {
          return animated_default(v, [](const auto& x) { return key_default(x); });
        }));
  }
  template <class T>
  void animated(std::string_view name, const T& a, std::string_view doc) {
    animated(name, a, Range{}, doc);
  }
  template <class T>
  void object(std::string_view name, T& o, std::string_view doc) {
    add(name, described(o), doc);
  }
  template <class T>
  void list(std::string_view name, const T&, const Count& count, std::string_view doc) {
    add(name, list_schema(element_schema<typename Held<T>::value_type>(), count), doc);
  }
  template <class T>
  void list(std::string_view name, const T& l, std::string_view doc) {
    list(name, l, Count{}, doc);
  }
  template <class T>
  void pairs(std::string_view name, const T&, std::string_view doc) {
    add(name, pairs_schema(), doc);
  }
  template <class T, class Kinds>
  void tagged(std::string_view name, const T&, const Kinds& kinds, std::string_view doc) {
    add(name, tagged_schema<Held<T>>(kinds), doc);
  }
  template <class T, class Kinds>
  void tagged_list(std::string_view name, const T&, const Kinds& kinds, std::string_view doc) {
    add(name, list_schema(tagged_schema<typename Held<T>::value_type>(kinds), {}), doc);
  }
  template <class T, class Kinds>
  void inheriting_list(const Inheritance& names, const std::vector<T>&, const Kinds& kinds,
                       std::string_view doc) {
    Value all = defaults_of<T>(kinds);
    add(names.force, forced_schema(all),
        "Properties that all organisms take from the defaults, whatever their own value");
    add(names.defaults, std::move(all), "Properties of all organisms that do not give their own");
    Value element = without_required(tagged_schema<T>(kinds));
    auto has = [](std::string_view name) {
      return make_object().set("required", make_list({make_text(name)}));
    };
    element.remove("required");
    element.set("anyOf", make_list({has("kind"), has(names.instead)}));
    add(names.list, list_schema(element, {}), doc);
  }
  template <class T, class Read>
  void custom(std::string_view name, const T&, Read, std::string_view schema, std::string_view doc) {
    add(name, written_schema(schema), doc);
  }
  void origin(std::string&, std::string_view = {}) const {}
  void given(std::string_view, bool&) const {}
  void required(std::string_view name) { required_.push_back(name); }
  void shorthand(std::string_view name) { bare_ = name; }
  /// Of a kind: the properties that shape it most, as paths ("habit/droop"), the most telling first. They
  /// stand in its part of the schema under "leading", an annotation.
  void leading(std::span<const std::string_view> paths) { leading_.assign(paths.begin(), paths.end()); }
  template <class... Names>
  void aspect(Aspect, Names...) const {}

  /// The description so far.
  Value object_schema() const;

 private:
  static Value type(std::string_view name) { return make_object().set("type", make_text(name)); }
  static Value key_schema(const Range& range, const Animated<double>&) { return number_schema(range); }
  static Value key_schema(const Range& range, const Animated<Vec3>&) {
    return vector_schema(number_schema(range), 3);
  }
  template <class T>
  static Value key_shape(const Animated<T>&) {
    return of<KeyShape<T>>();
  }
  static Value key_default(double x) { return tidy_number(x); }
  static Value key_default(Vec3 x) { return vector_default(x); }
  static std::string_view angle_unit(const Range& range) {
    return range.unit.empty() ? "degrees" : range.unit;
  }
  static std::string with_choices(std::string_view doc, const std::vector<std::string_view>& names,
                                  const std::vector<std::string_view>& docs);
  static Value forced_schema(const Value& defaults);
  static Value written_schema(std::string_view json);
  /// `common` (of all kinds) with the properties of each kind added where "kind" has its name.
  struct KindSchema {
    std::string_view name;
    std::string_view doc;
    Value schema;
    std::vector<std::string_view> leading;
  };
  static Value joined_kinds(const Value& common, const std::vector<KindSchema>& kinds);

  template <class V>
  static Value vector_default(const V& v) {
    Value list = make_list();
    for (int i = 0; i < V::length(); ++i) list.items.push_back(tidy_number(v[i]));
    return list;
  }
  template <class T, class Print>
  static Value animated_default(const Animated<T>& a, Print print) {
    if (a.constant()) return print(a.keys()[0].value);
    Value keys = make_list();
    for (const auto& key : a.keys())
      keys.items.push_back(make_list({make_number(key.time), print(key.value)}));
    return keys;
  }
  template <class T>
  static Range whole_range(Range range);

  /// The default of a property, null where it has none.
  template <class T, class Print>
  static Value initial(const T& value, Print print) {
    return print(value);
  }
  template <class T, class Print>
  static Value initial(const std::optional<T>& value, Print print) {
    return value ? print(*value) : Value{};
  }
  template <class T>
  static Value described(T& sample) {
    SchemaWriter writer;
    describe(writer, sample);
    return writer.object_schema();
  }
  template <class T>
  static Value described(std::optional<T>&) {
    return of<T>();
  }
  template <class T>
  static Value element_schema();
  template <class T, class Kinds>
  static std::vector<KindSchema> kind_schemas(const Kinds& kinds);
  template <class T, class Kinds>
  static Value tagged_schema(const Kinds& kinds) {
    return joined_kinds(of<T>(), kind_schemas<T>(kinds));
  }

  void add(std::string_view name, Value schema, std::string_view doc, std::string_view unit = {},
           Value initial = {});

  Value properties_ = make_object();
  std::vector<std::string_view> required_;
  std::string_view bare_;
  std::vector<std::string_view> leading_;
};

template <class T>
Range SchemaWriter::whole_range(Range range) {
  if (std::is_unsigned_v<T> && range.min < 0) range.min = 0, range.above_min = false;
  return range;
}

template <class T>
Value SchemaWriter::element_schema() {
  if constexpr (std::is_same_v<T, std::string>) {
    return type("string");
  } else if constexpr (std::is_floating_point_v<T>) {
    return number_schema({});
  } else if constexpr (std::is_integral_v<T>) {
    return integer_schema(whole_range<T>({}));
  } else if constexpr (std::is_same_v<T, Color>) {
    return color_schema();
  } else if constexpr (requires { T::length(); }) {
    return vector_schema(number_schema({}), T::length());
  } else {
    return of<T>();
  }
}

template <class T, class Kinds>
std::vector<SchemaWriter::KindSchema> SchemaWriter::kind_schemas(const Kinds& kinds) {
  std::vector<KindSchema> schemas;
  for (const auto& kind : kinds) {
    SchemaWriter writer;
    kind.schema(writer);
    schemas.push_back({kind.name, kind.doc, writer.object_schema(), writer.leading_});
  }
  return schemas;
}

template <class T, class Kinds>
Value SchemaWriter::defaults_of(const Kinds& kinds) {
  Value all = of<T>();
  for (const KindSchema& kind : kind_schemas<T>(kinds)) all = either(all, kind.schema);
  return without_required(std::move(all));
}

/// The JSON Schema of presets for a described struct, as a file.
template <class T>
std::string schema_text(std::string_view title, std::string_view doc) {
  Value schema = SchemaWriter::of<T>();
  Value top = make_object();
  top.set("$schema", make_text("http://json-schema.org/draft-07/schema#"));
  top.set("title", make_text(title)).set("description", make_text(doc));
  for (Member& member : schema.members) top.set(member.name, std::move(member.value));
  Value& properties = *top.find("properties");
  properties.members.insert(properties.members.begin(), Member{"$schema", {}, make_object()});
  properties.members.front().value.set("type", make_text("string"));
  return serialize_pretty(top);
}

}  // namespace frond
