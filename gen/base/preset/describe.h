#pragma once

#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/function_ref.h"
#include "core/result.h"
#include "preset/slot.h"

namespace frond {

// How a parameter struct is described
// ===================================
// One function beside the struct is enough: it is used to read the struct from JSON (Reader) and to print the
// schema (SchemaWriter), and so the documentation, and to make its keys (KeyWriter), by which what is made
// from it is found again. The struct's initial values are the defaults.
//
//     struct Wave {
//       double speed = 1;
//       float amplitude = 0.2f;   // radians
//       bool loop = true;
//     };
//
//     void describe(Properties& v, Wave& w) {
//       v.number("speed", w.speed, {.min = 0, .max = 10}, "Swings a second");
//       v.angle("amplitude", w.amplitude, {.min = 0, .max = 90}, "How far a tip leans");
//       v.boolean("loop", w.loop, "Whether the film can be repeated without a jump");
//     }
//
// It is called with a new struct to fill, or with the defaults to print, and must do nothing else with them.
// Names and docs are string literals. The properties are those of class Properties below:
//
//     number(name, x, range, doc)          double, float
//     angle(name, x, range, doc)           the same; degrees in JSON and in the range, radians in the struct
//     integer(name, n, range, doc)         any integer type; beyond the type and 2^53 is refused by itself
//     boolean(name, b, doc)
//     text(name, s, doc)                   std::string
//     file(name, f, load, doc [, needed])  FileName; `Errors load(const NamedFile&)` takes what the file
//                                          holds, if it is needed and files are to be read
//     choice(name, e, table, doc)          an enum by its name in a constexpr array of Choice (below)
//     vector(name, v, [range,] doc)        Vec3, DVec3, Vec2, DVec2 from [x, y, z] or [x, y]
//     direction(name, v, [across,] doc)    Vec3, DVec3 of some length; across: what of it counts
//     size(name, s, range, doc)            std::array<int, 2> from [width, height]
//     color(name, c, doc)                  Color as CSS writes it, or [r, g, b], each 0 to 1 (sRGB)
//     curve(name, c, doc)                  Curve from [[x, y], ...], two or more points, x increasing
//     animated(name, a, range, doc)        Animated<double>: a number, or keyframes [[seconds, number], ...]
//     animated(name, a, [range,] doc)      Animated<Vec3>: [x, y, z] or keyframes of these; each keyframe
//                                          may end with a KeyShape (eases.h)
//     object(name, o, doc)                 a struct with a describe() of its own
//     list(name, l, [count,] doc)          std::vector of described structs, texts, numbers, vectors, Color
//     pairs(name, p, doc)                  std::vector<std::pair<std::string, std::string>>, in the order
//                                          written, from an object of numbers (as shortest text) and texts
//     tagged(name, t, kinds, doc)          an object whose "kind" says how it is read (Kind, below)
//     tagged_list(name, l, kinds, doc)     a list of such
//     inheriting_list(names, l, kinds, doc)  a list of such, with defaults behind it (Inheritance, below)
//     origin(s [, name])                   std::string: where the object, or that property, stands in a file
//     given(name, b)                       whether the object itself gives that property
//     required(name)                       that property must be given; after the line that reads it
//     shorthand(name)                      first of all: a bare value in place of the object is read as this
//                                          property of it, so "A -> B" as {"rule": "A -> B"}. Not for a Kind.
//     leading(paths)                       of a Kind: the properties that shape it most, as paths
//                                          ("habit/droop"), the most telling first; they stand in its part
//                                          of the schema under "leading", an annotation
//     aspect(aspect)                       what the properties after this line tell (Aspect, below); without
//                                          it they tell what the object that holds them does, at first shape
//     aspect(aspect, names...)             what these properties tell; after the lines that read them
//     custom(name, x, read, schema, doc)   all else: `bool read(Reader&, const Value&, X&)` notes faults by
//                                          Reader::fault and says whether x was read; `schema` is JSON text
//     purpose()                            what all this is for, for the few that need to know
//
// Each that reads a property also takes a std::optional of its type, which stays empty where it is not given.
// The doc says what a property is, range.unit in which unit; both stand in the schema.
//
// What of a value counts in its keys besides its properties, or is custom, is added by a function beside it:
// `void describe_rest(KeyWriter&, X&)`. Both are declared where the struct is used as a property.

/// The allowed numbers, ends included. The unit is for the documentation, the sense (meaning of single
/// numbers) for error messages about values of another type.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  ///< min itself is not allowed
  std::string_view unit = {};
  std::string_view sense = {};

  bool holds(double x) const { return (above_min ? x > min : x >= min) && x <= max; }
};

/// The range of a share, and of what goes from none to full.
inline constexpr Range kShare{.min = 0, .max = 1};

/// The range of a length, metres.
constexpr Range metres(double min, double max) { return {.min = min, .max = max, .unit = "m"}; }

/// What a property tells of what is made from it.
enum class Aspect {
  shape,   ///< what grows: its branches, and where its organs are
  look,    ///< only how it looks
  motion,  ///< only how it moves
};
inline constexpr std::size_t kAspects = 3;

/// Which components of a direction are used.
enum class Across { all, xz };

/// The range of a component of a direction: its square must be finite.
inline constexpr Range kDirections{.min = -1e6, .max = 1e6};

/// The allowed number of elements of a list.
struct Count {
  std::size_t min = 0;
  std::size_t max = std::numeric_limits<std::size_t>::max();
};

/// A row of the table of an enum:
///     inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "quick"}, ...};
template <class Enum>
struct Choice {
  std::string_view name;
  Enum value;
  std::string_view doc;
};

class KeyWriter;
class Reader;
struct FileName;
struct NamedFile;
struct Value;

/// Rows of a table with a name and a doc each, whatever they are.
class NamedRows {
 public:
  template <class Table>
  explicit NamedRows(const Table& table) : rows_(std::data(table)), size_(std::size(table)) {
    using Row = std::remove_cvref_t<decltype(*std::data(table))>;
    row_ = [](const void* rows, std::size_t i) -> std::pair<std::string_view, std::string_view> {
      const Row& row = static_cast<const Row*>(rows)[i];
      return {row.name, row.doc};
    };
  }

  std::size_t size() const { return size_; }
  std::string_view name(std::size_t i) const { return row_(rows_, i).first; }
  std::string_view doc(std::size_t i) const { return row_(rows_, i).second; }
  std::vector<std::string_view> names() const {
    std::vector<std::string_view> all;
    for (std::size_t i = 0; i < size_; ++i) all.push_back(name(i));
    return all;
  }

 protected:
  const void* rows_;

 private:
  std::size_t size_;
  std::pair<std::string_view, std::string_view> (*row_)(const void*, std::size_t);
};

/// The table of an enum, whichever it is of.
class ChoiceTable : public NamedRows {
 public:
  template <class Table>
  ChoiceTable(const Table& table) : NamedRows(table) {
    using Row = std::remove_cvref_t<decltype(*std::data(table))>;
    using Enum = decltype(Row::value);
    is_ = [](const void* rows, std::size_t i, const void* e) {
      return static_cast<const Row*>(rows)[i].value == *static_cast<const Enum*>(e);
    };
    set_ = [](const void* rows, std::size_t i, void* e) {
      *static_cast<Enum*>(e) = static_cast<const Row*>(rows)[i].value;
    };
  }

  /// The name of a value; empty where it is that of no row.
  std::string_view name_of(Slot e) const {
    std::string_view found;
    for (std::size_t i = 0; i < size(); ++i)
      if (is_(rows_, i, e.at)) found = name(i);
    return found;
  }
  void set(std::size_t i, Slot e) const { set_(rows_, i, e.at); }

 private:
  bool (*is_)(const void*, std::size_t, const void*);
  void (*set_)(const void*, std::size_t, void*);
};

/// A row of the table of kinds of a T. `describe(v, T&)` gives the properties common to all kinds (it may be
/// empty), the row makes it one of its kind and gives those of that; no name may be in both. The name "kind"
/// is reserved.
template <class T>
struct Kind {
  std::string_view name;
  std::string_view doc;
  void (*describe)(Properties&, T&);
};

/// The table of kinds, of whatever they are.
class KindTable : public NamedRows {
 public:
  template <class Table>
  KindTable(const Table& table) : NamedRows(table) {
    describe_ = [](const void* rows, std::size_t i, Properties& v, void* one) {
      describe_as(static_cast<decltype(std::data(table))>(rows)[i], v, one);
    };
  }

  void describe(std::size_t i, Properties& v, Slot one) const { describe_(rows_, i, v, one.at); }

 private:
  template <class T>
  static void describe_as(const Kind<T>& kind, Properties& v, void* one) {
    kind.describe(v, *static_cast<T*>(one));
  }

  void (*describe_)(const void*, std::size_t, Properties&, void*);
};

/// The names of the three properties of a list with defaults: each element is merged with the object
/// `defaults` (merge(): the element wins) except for the properties listed in `force`. `defaults` may have
/// properties of any kind; an element ignores those that its kind does not have.
struct Inheritance {
  std::string_view list = "organisms";
  std::string_view defaults = "defaults";
  std::string_view force = "force";
  std::string_view instead = "species";  ///< an element with this property may omit its kind
};

/// What visits a described struct.
enum class Purpose { reading, schema, keys };

using LoadFile = FunctionRef<Errors(const NamedFile&)>;
using ReadCustom = FunctionRef<void(Reader&, const Value&)>;

/// A visitor of described structs, see the top of this file.
class Properties {
 public:
  virtual ~Properties() = default;
  virtual Purpose purpose() const = 0;

  void number(std::string_view name, RealSlot x, const Range& range, std::string_view doc) {
    visit_value(name, x, range, doc);
  }
  virtual void angle(std::string_view name, RealSlot x, const Range& range, std::string_view doc) = 0;
  void integer(std::string_view name, IntegerSlot n, const Range& range, std::string_view doc) {
    visit_value(name, n, range, doc);
  }
  void boolean(std::string_view name, BooleanSlot b, std::string_view doc) { visit_value(name, b, {}, doc); }
  void text(std::string_view name, TextSlot s, std::string_view doc) { visit_value(name, s, {}, doc); }
  virtual void file(std::string_view name, FileName& file, LoadFile load, std::string_view doc,
                    bool needed = true) = 0;
  template <class T, class Table>
  void choice(std::string_view name, T& e, const Table& table, std::string_view doc) {
    static_assert(std::is_same_v<Held<T>, decltype(std::data(table)->value)>);
    choose(name, slot_of(e), table, doc);
  }
  void vector(std::string_view name, VectorSlot v, const Range& range, std::string_view doc) {
    visit_value(name, v, range, doc);
  }
  void vector(std::string_view name, VectorSlot v, std::string_view doc) { visit_value(name, v, {}, doc); }
  virtual void direction(std::string_view name, VectorSlot v, Across across, std::string_view doc) = 0;
  void direction(std::string_view name, VectorSlot v, std::string_view doc) {
    direction(name, v, Across::all, doc);
  }
  void size(std::string_view name, SizeSlot s, const Range& range, std::string_view doc) {
    visit_value(name, s, range, doc);
  }
  void color(std::string_view name, ColorSlot c, std::string_view doc) { visit_value(name, c, {}, doc); }
  void curve(std::string_view name, CurveSlot c, std::string_view doc) { visit_value(name, c, {}, doc); }
  void animated(std::string_view name, AnimatedSlot a, const Range& range, std::string_view doc) {
    visit_value(name, a, range, doc);
  }
  void animated(std::string_view name, AnimatedSlot a, std::string_view doc) {
    visit_value(name, a, {}, doc);
  }
  void object(std::string_view name, ObjectSlot o, std::string_view doc) { visit_value(name, o, {}, doc); }
  virtual void list(std::string_view name, ListSlot l, const Count& count, std::string_view doc) = 0;
  void list(std::string_view name, ListSlot l, std::string_view doc) { list(name, l, Count{}, doc); }
  void pairs(std::string_view name, PairsSlot p, std::string_view doc) { visit_value(name, p, {}, doc); }
  void tagged(std::string_view name, ObjectSlot o, const KindTable& kinds, std::string_view doc) {
    visit_tagged(name, o, kinds, doc);
  }
  void tagged_list(std::string_view name, ListSlot l, const KindTable& kinds, std::string_view doc) {
    visit_tagged(name, l, kinds, doc);
  }
  virtual void inheriting_list(const Inheritance& names, ListSlot l, const KindTable& kinds,
                               std::string_view doc) = 0;
  template <class T, class Read>
  void custom(std::string_view name, T& out, const Read& read, std::string_view schema,
              std::string_view doc) {
    auto assign = [&](Reader& reader, const Value& value) {
      Held<T> held{};
      if (read(reader, value, held)) out = std::move(held);
    };
    read_custom(name, slot_of(out), assign, schema, doc);
  }

  virtual void origin(std::string& /*out*/, std::string_view /*name*/ = {}) {}
  virtual void given(std::string_view /*name*/, bool& /*out*/) {}
  virtual void required(std::string_view /*name*/) {}
  virtual void shorthand(std::string_view /*name*/) {}
  virtual void leading(std::span<const std::string_view> /*paths*/) {}
  virtual void aspect(Aspect /*of_all_after*/) {}
  template <class... Names>
  void aspect(Aspect aspect, std::string_view name, Names... names) {
    move_to(aspect, name), (move_to(aspect, names), ...);
  }

 protected:
  /// What is read and printed by the type of its slot alone; `range` holds for all numbers in it.
  virtual void visit_value(std::string_view name, Slot x, const Range& range, std::string_view doc) = 0;
  /// An object that says its kind, or a list of such.
  virtual void visit_tagged(std::string_view name, Slot x, const KindTable& kinds, std::string_view doc) = 0;
  virtual void choose(std::string_view name, Slot e, const ChoiceTable& table, std::string_view doc) = 0;
  virtual void read_custom(std::string_view name, Slot x, ReadCustom read, std::string_view schema,
                           std::string_view doc) = 0;
  virtual void move_to(Aspect, std::string_view /*name*/) {}
};

// For tables of described structs, where no visitor is to be known.

/// Reads a described struct at that value; true if there was no fault.
bool read_object(Reader& reader, const Value& value, ObjectSlot object);
/// The schema of a described struct with its initial values, as JSON on one line.
std::string schema_json(ObjectSlot object);

}  // namespace frond
