#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

/// Where a value was written: a position in a file (line and column count from 1, columns in characters), or
/// a source without lines, such as `--set /film/fps`.
struct Origin {
  std::shared_ptr<const std::string> source;
  int line = 0;
  int column = 0;

  /// `file:line:column`, or the bare name of a source without lines.
  std::string text() const;
};

struct Member;

/// A JSON value as written: members keep their order, and each value has its origin.
struct Value {
  enum class Type { null, boolean, number, text, list, object };

  Type type = Type::null;
  bool boolean = false;
  bool integer = false;         ///< of a number: written without fraction and exponent
  bool inherited = false;       ///< merge() took it from the defaults
  double number = 0;            ///< always finite
  std::string text;             ///< UTF-8
  std::vector<Value> items;     ///< elements of a list
  std::vector<Member> members;  ///< of an object; names are unique
  Origin origin;

  bool is(Type other) const { return type == other; }

  /// The member of that name, or nullptr; also if this is no object.
  const Value* find(std::string_view name) const;
  Value* find(std::string_view name);

  /// Sets a member of the object, replacing an earlier one of that name. Returns this.
  Value& set(std::string_view name, Value value);

  /// Removes the member of that name, if there is one.
  void remove(std::string_view name);
};

struct Member {
  std::string name;
  Origin origin;  ///< of the name
  Value value;
};

/// Values without an origin.
Value make_boolean(bool boolean);
Value make_number(double number);
Value make_text(std::string_view text);
Value make_list(std::vector<Value> items = {});
Value make_object(std::vector<Member> members = {});

/// A list of texts from anything convertible to string_view.
template <class Names>
Value make_texts(const Names& names) {
  Value list = make_list();
  for (const auto& name : names) list.items.push_back(make_text(name));
  return list;
}

/// A value as named in messages: `12.5`, `the text "abc"`, `a list of 3`, `an object`.
std::string found_text(const Value& value);

/// `pointer` with one more step, escaped as in RFC 6901 (`~` becomes `~0`, `/` becomes `~1`).
std::string pointer_step(std::string_view pointer, std::string_view name);

/// Origin of the value at the pointer; if there is none, of the innermost existing parent. For errors found
/// after reading.
Origin origin_at(const Value& root, std::string_view pointer);

/// The second part of a message: `; expected one of a, b, c; did you mean "b"?`. In a long list the nearest
/// names come first, and the rest is only counted.
std::string expected_names(std::string_view found, std::span<const std::string_view> names);

}  // namespace frond
