#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/assets.h"
#include "core/curve.h"
#include "core/vec.h"
#include "preset/describe.h"

namespace frond {

/// What stands for a described value in names of files and in caches: hashes of its properties' names and of
/// their values as they were read. So a default may be written out or left out, and the order, the spelling
/// and the place of what is written do not count. Files that properties name count by what they hold.
struct Keys {
  std::string shape;   ///< of all that tells what grows
  std::string look;    ///< of all that tells only how it looks
  std::string motion;  ///< of all that tells only how it moves

  /// Of all of them.
  std::string all() const { return shape + look + motion; }
  bool operator==(const Keys&) const = default;
};

/// The visitor that makes the keys of described structs (describe.h). Use keys_of() below.
class KeyWriter {
 public:
  KeyWriter() = default;
  Keys keys() const;

  /// Adds a value that is no property of its own.
  template <class T>
  void add(std::string_view name, T& x) {
    Entry entry;
    entry.name = name;
    append(entry.texts, x);
    entries_.push_back(std::move(entry));
  }

  // The properties, see describe.h.

#define FROND_ADDS(property, Limits)                                            \
  template <class T>                                                            \
  void property(std::string_view name, T& x, const Limits&, std::string_view) { \
    add(name, x);                                                               \
  }                                                                             \
  template <class T, class... Rest>                                             \
  void property(std::string_view name, T& x, const Rest&...) {                  \
    add(name, x);                                                               \
  }
  FROND_ADDS(number, Range)
  FROND_ADDS(angle, Range)
  FROND_ADDS(integer, Range)
  FROND_ADDS(boolean, Range)
  FROND_ADDS(text, Range)
  FROND_ADDS(vector, Range)
  FROND_ADDS(direction, Across)
  FROND_ADDS(size, Range)
  FROND_ADDS(color, Range)
  FROND_ADDS(curve, Range)
  FROND_ADDS(animated, Range)
  FROND_ADDS(object, Range)
  FROND_ADDS(list, Count)
  FROND_ADDS(pairs, Range)
  FROND_ADDS(tagged, Range)
  FROND_ADDS(tagged_list, Range)
  FROND_ADDS(custom, Range)
#undef FROND_ADDS

  template <class Load>
  void file(std::string_view name, FileName& file, const Load&, std::string_view, bool = true) {
    add(name, file.content.empty() ? file.name : file.content);
  }
  template <class T, class Table>
  void choice(std::string_view name, T& e, const Table& table, std::string_view) {
    std::string_view chosen;
    for (const auto& row : table)
      if (e == row.value) chosen = row.name;
    add(name, chosen);
  }
  template <class T, class Kinds>
  void inheriting_list(const Inheritance& names, T& list, const Kinds&, std::string_view) {
    add(names.list, list);
  }
  void origin(std::string&, std::string_view = {}) const {}
  void given(std::string_view, bool&) const {}
  void required(std::string_view) const {}
  void shorthand(std::string_view) const {}
  void aspect(Aspect aspect) { own_ = aspect; }
  template <class... Names>
  void aspect(Aspect aspect, Names... names) {
    (move_to(aspect, names), ...);
  }

 private:
  using Texts = std::array<std::string, kAspects>;
  struct Entry {
    std::string_view name;
    Texts texts;  // of each aspect
  };

  static void append_value(std::string& text, double x);
  static void append_value(std::string& text, std::string_view s);
  /// The text of a name's value becomes part of an aspect.
  void move_to(Aspect aspect, std::string_view name);
  /// Adds all that an object tells of each aspect.
  void append_to(Texts& texts) const;

  template <class T>
  void append(Texts& texts, T& x);
  template <class T>
  void append_object(Texts& texts, T& object) {
    KeyWriter inner;
    inner.own_ = own_;
    constexpr bool has_properties = requires { describe(inner, object); };
    constexpr bool has_rest = requires { describe_rest(inner, object); };
    static_assert(has_properties || has_rest, "nothing says what of it counts");
    if constexpr (has_properties) describe(inner, object);
    if constexpr (has_rest) describe_rest(inner, object);
    inner.append_to(texts);
  }

  Aspect own_ = Aspect::shape;
  std::vector<Entry> entries_;
};

template <class T>
void KeyWriter::append(Texts& texts, T& x) {
  using Plain = std::remove_const_t<T>;
  std::string& own = texts[static_cast<std::size_t>(own_)];
  if constexpr (std::is_arithmetic_v<Plain>) {
    append_value(own, static_cast<double>(x));
  } else if constexpr (std::is_convertible_v<Plain, std::string_view>) {
    append_value(own, x);
  } else if constexpr (std::is_same_v<Plain, Keys>) {
    texts[static_cast<std::size_t>(Aspect::shape)] += x.shape;
    texts[static_cast<std::size_t>(Aspect::look)] += x.look;
    texts[static_cast<std::size_t>(Aspect::motion)] += x.motion;
  } else if constexpr (std::is_same_v<Plain, Color>) {
    for (float part : {x.red, x.green, x.blue}) append(texts, part);
  } else if constexpr (std::is_same_v<Plain, Curve>) {
    for (const Vec2& point : x.points()) append(texts, point);
  } else if constexpr (requires { x.keys(); }) {
    for (const auto& key : x.keys()) {
      append(texts, key.time), append(texts, key.value);
      if (key.ease) append_value(own, "ease"), append_value(own, static_cast<double>(*key.ease));
      if (key.in) append_value(own, "in"), append(texts, *key.in);
      if (key.out) append_value(own, "out"), append(texts, *key.out);
    }
  } else if constexpr (requires { Plain::length(); }) {
    for (int i = 0; i < Plain::length(); ++i) append(texts, x[i]);
  } else if constexpr (requires {
                         x.has_value();
                         *x;
                       }) {
    if (x) append(texts, *x);
  } else if constexpr (requires { x.first; }) {
    append(texts, x.first), append(texts, x.second);
  } else if constexpr (requires {
                         x.size();
                         x.begin();
                       }) {
    append_value(own, static_cast<double>(x.size()));  // lists of lists are told apart
    for (auto& element : x) append(texts, element);
  } else {
    append_object(texts, x);
  }
}

/// The keys of described values together.
template <class... T>
Keys keys_of(T... values) {
  KeyWriter writer;
  (writer.add("", values), ...);
  return writer.keys();
}

}  // namespace frond
