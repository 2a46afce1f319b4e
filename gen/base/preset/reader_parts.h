#pragma once

// The longer templates of Reader; included by reader.h.

#include <limits>

#include "preset/reader.h"

namespace frond {

template <class T>
Range Reader::within(Range range) {
  constexpr double kExact = 9007199254740992.0;  // not all integers beyond 2^53 are doubles
  double low = static_cast<double>(std::numeric_limits<T>::lowest());
  double high = static_cast<double>(std::numeric_limits<T>::max());
  if (std::is_integral_v<T>) {
    low = std::max(low, -kExact);
    high = std::min(high, kExact);
  }
  if (range.min < low) range.min = low;
  if (range.max > high) range.max = high;
  return range;
}

template <class T, class Read>
void Reader::list_at(const Value& value, std::vector<T>& out, const Count& count, Read read) {
  if (!check_list(value, count)) return;
  std::vector<T> elements;
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    T element{};
    inside(std::to_string(i), [&] { return read(value.items[i], element); });
    elements.push_back(std::move(element));
  }
  out = std::move(elements);
}

template <class T>
bool Reader::element_at(const Value& value, T& out) {
  if constexpr (std::is_same_v<T, std::string>) {
    return keep(out, text_at(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    return keep(out, real_at<T>(value, {}));
  } else if constexpr (std::is_integral_v<T>) {
    return keep(out, integer_at<T>(value, {}));
  } else if constexpr (std::is_same_v<T, Color>) {
    return keep(out, color_at(value));
  } else if constexpr (requires { T::length(); }) {
    return keep(out, vector_at<T>(value, {}));
  } else {
    return object_at(value, out);
  }
}

template <class T, class Kinds>
bool Reader::tagged_at(const Value& value, T& out, const Kinds& kinds) {
  if (!value.is(Value::Type::object)) return fault(value, "an object"), false;
  std::vector<std::string_view> names;
  for (const auto& kind : kinds) names.push_back(kind.name);
  const Value* name = value.find("kind");
  if (!name) {
    faults_.add({value.origin, pointer_, "no \"kind\"" + expected_names("", names)});
    return false;
  }
  std::optional<std::size_t> which = inside("kind", [&] { return name_at(*name, names); });
  if (!which) return false;
  return with_object(value, [&] {
    take("kind");
    describe(*this, out);
    std::data(kinds)[*which].read(*this, out);
  });
}

template <class T, class Kinds>
void Reader::inheriting_list(const Inheritance& names, std::vector<T>& out, const Kinds& kinds,
                             std::string_view) {
  // Defaults may have properties of any kind, so each kind reads them.
  Value nothing = make_object();
  const Value* defaults = &nothing;
  member(names.defaults, [&](const Value& value) {
    if (!value.is(Value::Type::object)) return fault(value, "an object");
    defaults = &value;
    std::vector<std::vector<Fault>> readings;
    for (const auto& kind : kinds) {
      Reader reader(true);
      reader.pointer_ = pointer_;
      T sample{};
      reader.with_object(value, [&] {
        describe(reader, sample);
        kind.read(reader, sample);
      });
      readings.push_back(reader.faults().list());
    }
    for (Fault& fault : common_faults(readings)) faults_.add(std::move(fault));
  });

  std::vector<std::string> force;
  member(names.force, [&](const Value& value) {
    list_at(value, force, {}, [&](const Value& item, std::string& path) {
      return element_at(item, path) && check_path(item, path, SchemaWriter::defaults_of<T>(kinds));
    });
  });

  member(names.list, [&](const Value& value) {
    list_at(value, out, {}, [&](const Value& item, T& element) {
      // What is forced out must be right too.
      T unforced{};
      bool good = tagged_at(merge(*defaults, item), unforced, kinds);
      if (force.empty()) {
        element = std::move(unforced);
        return good;
      }
      return tagged_at(merge(*defaults, item, force), element, kinds) && good;
    });
  });
}

}  // namespace frond
