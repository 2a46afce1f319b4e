#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/assets.h"
#include "core/content.h"
#include "core/curve.h"
#include "core/vec.h"
#include "preset/describe.h"
#include "preset/fault.h"
#include "preset/json.h"
#include "preset/merge.h"
#include "preset/schema.h"

namespace frond {

/// The visitor that reads described structs (describe.h) from JSON values. All errors are collected; a member
/// with an error keeps its old value. Use read_preset() below.
class Reader {
 public:
  /// With `partial`, missing properties are allowed: the values read are defaults for another object.
  explicit Reader(bool partial = false) : partial_(partial) {}

  /// Reads the files that properties name; without this call only their names are read.
  void read_files(const Assets& assets) { assets_ = &assets; }

  const Faults& faults() const { return faults_; }
  /// Warnings: valid, but probably not intended.
  const Faults& doubts() const { return doubts_; }

  /// Reads a whole document; "$schema" is allowed there.
  template <class T>
  void read_root(const Value& root, T& out) {
    pointer_.clear();
    with_object(root, [&] {
      std::string schema;
      text("$schema", schema, "");
      describe(*this, out);
    });
  }

  // The properties, see describe.h.

  template <class T>
  void number(std::string_view name, T& out, const Range& range, std::string_view) {
    static_assert(std::is_floating_point_v<Held<T>>);
    member(name, [&](const Value& v) { return keep(out, real_at<Held<T>>(v, range)); });
  }
  template <class T>
  void angle(std::string_view name, T& out, const Range& range, std::string_view) {
    static_assert(std::is_floating_point_v<Held<T>>);
    member(name, [&](const Value& v) {
      auto degrees = number_at(v, in_degrees(within<Held<T>>(range)));
      if constexpr (std::is_same_v<T, Held<T>>)
        if (degrees) doubt_radians(v, *degrees, frond::degrees(static_cast<double>(out)));
      return keep(out, degrees ? std::optional(static_cast<Held<T>>(radians(*degrees))) : std::nullopt);
    });
  }
  template <class T>
  void integer(std::string_view name, T& out, const Range& range, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, integer_at<Held<T>>(v, range)); });
  }
  template <class T>
  void boolean(std::string_view name, T& out, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, boolean_at(v)); });
  }
  template <class T>
  void text(std::string_view name, T& out, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, text_at(v)); });
  }
  template <class Load>
  void file(std::string_view name, FileName& out, const Load& load, std::string_view, bool needed = true) {
    member(name, [&](const Value& v) {
      out.content.clear();
      if (!keep(out.name, text_at(v)) || !assets_ || !needed) return;
      std::optional<NamedFile> found = file_at(v);
      if (!found) return;
      out.content = content_id(found->text);
      note_faults(v, *found, load(*found));
    });
  }
  template <class T, class Table>
  void choice(std::string_view name, T& out, const Table& table, std::string_view) {
    member(name, [&](const Value& v) {
      std::vector<std::string_view> names;
      for (const auto& row : table) names.push_back(row.name);
      std::optional<std::size_t> which = name_at(v, names);
      if (which) out = std::data(table)[*which].value;
    });
  }
  template <class T>
  void vector(std::string_view name, T& out, const Range& range, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, vector_at<Held<T>>(v, range)); });
  }
  template <class T>
  void vector(std::string_view name, T& out, std::string_view doc) {
    vector(name, out, Range{}, doc);
  }
  template <class T>
  void direction(std::string_view name, T& out, Across across, std::string_view) {
    member(name, [&](const Value& v) {
      auto read = vector_at<Held<T>>(v, kDirections);
      return read && has_length(v, DVec3(*read), across) && keep(out, read);
    });
  }
  template <class T>
  void direction(std::string_view name, T& out, std::string_view doc) {
    direction(name, out, Across::all, doc);
  }
  template <class T>
  void size(std::string_view name, T& out, const Range& range, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, size_at(v, range)); });
  }
  template <class T>
  void color(std::string_view name, T& out, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, color_at(v)); });
  }
  template <class T>
  void curve(std::string_view name, T& out, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, curve_at(v)); });
  }
  template <class T>
  void animated(std::string_view name, T& out, const Range& range, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, animated_at(v, range, Held<T>{})); });
  }
  template <class T>
  void animated(std::string_view name, T& out, std::string_view doc) {
    animated(name, out, Range{}, doc);
  }
  template <class T>
  void object(std::string_view name, T& out, std::string_view) {
    member(name, [&](const Value& v) { object_at(v, hold(out)); });
  }
  template <class T>
  void list(std::string_view name, T& out, const Count& count, std::string_view) {
    member(name, [&](const Value& v) {
      list_at(v, hold(out), count,
              [&](const Value& item, auto& element) { return element_at(item, element); });
    });
  }
  template <class T>
  void list(std::string_view name, T& out, std::string_view doc) {
    list(name, out, Count{}, doc);
  }
  template <class T>
  void pairs(std::string_view name, T& out, std::string_view) {
    member(name, [&](const Value& v) { return keep(out, pairs_at(v)); });
  }
  template <class T, class Kinds>
  void tagged(std::string_view name, T& out, const Kinds& kinds, std::string_view) {
    member(name, [&](const Value& v) { tagged_at(v, hold(out), kinds); });
  }
  template <class T, class Kinds>
  void tagged_list(std::string_view name, T& out, const Kinds& kinds, std::string_view) {
    member(name, [&](const Value& v) {
      list_at(v, hold(out), {},
              [&](const Value& item, auto& element) { return tagged_at(item, element, kinds); });
    });
  }
  template <class T, class Kinds>
  void inheriting_list(const Inheritance& names, std::vector<T>& out, const Kinds& kinds,
                       std::string_view doc);

  template <class T, class Read>
  void custom(std::string_view name, T& out, Read read, std::string_view /*schema*/, std::string_view) {
    member(name, [&](const Value& v) {
      Held<T> held{};
      if (read(*this, v, held)) out = std::move(held);
    });
  }
  /// Position of the object being read, or of that property of it, as in messages.
  void origin(std::string& out, std::string_view name = {}) const;
  /// Whether the object itself gives the property, not the defaults behind it.
  void given(std::string_view name, bool& out) const;
  void required(std::string_view name);
  void shorthand(std::string_view name);
  template <class... Names>
  void aspect(Aspect, Names...) const {}

  // For custom properties: building blocks of the above. Each notes its errors.

  /// Notes `found <value>; expected <expected>` at the value being read.
  void fault(const Value& value, std::string_view expected);
  /// Runs `work` one level deeper: at the element or member of that name.
  template <class Work>
  auto inside(std::string_view step, Work work) {
    std::size_t parent = pointer_.size();
    pointer_ = pointer_step(pointer_, step);
    struct Leave {
      Reader& reader;
      std::size_t size;
      ~Leave() { reader.pointer_.resize(size); }
    } leave{*this, parent};
    return work();
  }
  std::optional<double> number_at(const Value& value, const Range& range);
  std::optional<bool> boolean_at(const Value& value);
  std::optional<std::string> text_at(const Value& value);
  /// Index of the text among the names.
  std::optional<std::size_t> name_at(const Value& value, std::span<const std::string_view> names);
  std::optional<std::array<int, 2>> size_at(const Value& value, const Range& range);
  std::optional<Color> color_at(const Value& value);
  std::optional<Curve> curve_at(const Value& value);
  std::optional<std::vector<std::pair<std::string, std::string>>> pairs_at(const Value& value);
  /// The last argument only selects the type.
  std::optional<Animated<double>> animated_at(const Value& value, const Range& range,
                                              const Animated<double>&);
  std::optional<Animated<Vec3>> animated_at(const Value& value, const Range& range, const Animated<Vec3>&);

  template <class T>
  std::optional<T> real_at(const Value& value, const Range& range) {
    auto x = number_at(value, within<T>(range));
    return x ? std::optional(static_cast<T>(*x)) : std::nullopt;
  }
  template <class T>
  std::optional<T> integer_at(const Value& value, const Range& range) {
    static_assert(std::is_integral_v<T> && !std::is_same_v<T, bool>);
    auto x = whole_at(value, within<T>(range));
    return x ? std::optional(static_cast<T>(*x)) : std::nullopt;
  }
  /// A vector of two or three numbers, float or double.
  template <class V>
  std::optional<V> vector_at(const Value& value, const Range& range) {
    std::array<double, V::length()> numbers;
    if (!numbers_at(value, within<typename V::value_type>(range), numbers)) return std::nullopt;
    V vector;
    for (int i = 0; i < V::length(); ++i) vector[i] = static_cast<typename V::value_type>(numbers[i]);
    return vector;
  }
  /// A described struct; true if there was no error.
  template <class T>
  bool object_at(const Value& value, T& out) {
    return with_object(value, [&] { describe(*this, out); });
  }
  template <class T, class Kinds>
  bool tagged_at(const Value& value, T& out, const Kinds& kinds);

 private:
  struct Frame {
    const Value* value;
    std::vector<std::string_view> names = {};
    std::string_view bare = {};
  };

  template <class T>
  static Range within(Range range);
  static Range in_degrees(Range range) {
    if (range.unit.empty()) range.unit = "degrees";
    return range;
  }
  /// Notes an angle that looks like radians (`usual` in radians) where degrees are expected.
  void doubt_radians(const Value& value, double found, double usual);
  /// Notes a direction without length.
  bool has_length(const Value& value, const DVec3& direction, Across across);
  /// The file that a text names; an empty text names none.
  std::optional<NamedFile> file_at(const Value& value);
  void note_faults(const Value& value, const NamedFile& file, const Errors& errors);
  std::optional<double> whole_at(const Value& value, const Range& range);
  bool numbers_at(const Value& value, const Range& range, std::span<double> out);
  template <class T, class Read>
  std::optional<Animated<T>> keys_at(const Value& value, bool constant, Read read);

  /// The member of the object being read, recorded as a known name; nullptr if it is missing.
  const Value* take(std::string_view name);
  void enter(const Value& value) { frames_.push_back(Frame{&value}); }
  void leave();

  template <class Read>
  void member(std::string_view name, Read read) {
    const Value* value = take(name);
    if (!value) return;
    if (value == frames_.back().value) {
      read(*value);
    } else {
      inside(name, [&] { read(*value); });
    }
  }
  template <class Read>
  bool with_object(const Value& value, Read read) {
    std::size_t before = faults_.list().size();
    enter(value);
    read();
    leave();
    return faults_.list().size() == before;
  }
  template <class T, class Read>
  void list_at(const Value& value, std::vector<T>& out, const Count& count, Read read);
  template <class T>
  bool element_at(const Value& value, T& out);
  bool check_list(const Value& value, const Count& count);
  /// Whether the path ("wave/amplitude") names a property of the schema of an object.
  bool check_path(const Value& value, std::string_view path, const Value& schema);

  template <class T, class Read>
  static bool keep(T& out, std::optional<Read> read) {
    if (read) out = std::move(*read);
    return read.has_value();
  }
  template <class T>
  static T& hold(T& out) {
    return out;
  }
  template <class T>
  static T& hold(std::optional<T>& out) {
    return out ? *out : out.emplace();
  }

  bool partial_;
  std::string pointer_;
  std::vector<Frame> frames_;
  Faults faults_, doubts_;
  const Assets* assets_ = nullptr;
};

/// Reads a document into a described struct, or returns everything that is wrong with it. Warnings go to
/// `doubts`. Named files are read from `assets`.
template <class T>
Result<T> read_preset(const Document& document, Faults* doubts = nullptr, const Assets* assets = nullptr) {
  T preset{};
  Reader reader;
  if (assets) reader.read_files(*assets);
  reader.read_root(document.root, preset);
  if (doubts) *doubts = reader.doubts();
  if (reader.faults().list().empty()) return preset;
  return reader.faults().errors();
}

}  // namespace frond

#include "preset/reader_parts.h"
