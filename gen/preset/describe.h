#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace frond {

// How a parameter struct is described
// ===================================
// One free function template beside the struct says all: it is used to read the struct from JSON (Reader), to
// print the schema (SchemaWriter) and so the documentation. The struct's own initial values are the defaults.
//
//     struct Wave {
//       double speed = 1;
//       float amplitude = 0.2f;   // radians
//       bool loop = true;
//     };
//
//     template <class Visitor>
//     void describe(Visitor& v, Wave& w) {
//       v.number("speed", w.speed, {.min = 0, .max = 10}, "Swings a second");
//       v.angle("amplitude", w.amplitude, {.min = 0, .max = 90}, "How far a tip leans");
//       v.boolean("loop", w.loop, "Whether the film can be repeated without a jump");
//     }
//
// It is called with a fresh struct to read into, or with the defaults to print; it does nothing else with
// them. Names and docs are string literals. Every visitor has:
//
//     number(name, x, range, doc)          double, float
//     angle(name, x, range, doc)           the same; degrees in JSON and in the range, radians in the struct
//     integer(name, n, range, doc)         any integer type; beyond the type and 2^53 is refused by itself
//     boolean(name, b, doc)
//     text(name, s, doc)                   std::string
//     file(name, s, load, doc [, needed])  std::string, the name of a file; `Errors load(const NamedFile&)`
//                                          takes what it holds, if it is needed and files are to be read
//     choice(name, e, table, doc)          an enum by its name in a constexpr array of Choice (below)
//     vector(name, v, [range,] doc)        Vec3, DVec3, Vec2, DVec2 from [x, y, z] or [x, y]
//     direction(name, v, [across,] doc)    Vec3, DVec3 of some length; across: what of it counts
//     size(name, s, range, doc)            std::array<int, 2> from [width, height]
//     color(name, c, doc)                  Color from "#rrggbb" or [r, g, b], each 0 to 1 (sRGB)
//     curve(name, c, doc)                  Curve from [[x, y], ...], two or more points, x increasing
//     animated(name, a, range, doc)        Animated<double>: a number, or keyframes [[seconds, number], ...]
//     animated(name, a, [range,] doc)      Animated<Vec3>: [x, y, z] or keyframes [[seconds, [x, y, z]], ...]
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
//     custom(name, x, read, schema, doc)   all else: `bool read(Reader&, const Value&, X&)` notes faults by
//                                          Reader::fault and says whether x was read; `schema` is JSON text
//
// Each that reads a property also takes a std::optional of its type, which stays empty where it is not given.
// The doc says what a property is, range.unit in which unit; both stand in the schema.

/// The numbers that are allowed, ends included. The unit is for the reader of the documentation only, the
/// sense (what single numbers mean) for who wrote something else.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  ///< min itself is not allowed
  std::string_view unit = {};
  std::string_view sense = {};

  bool holds(double x) const { return (above_min ? x > min : x >= min) && x <= max; }
};

/// What of a direction counts.
enum class Across { all, xz };

/// What a component of a direction may be: its square is still a number to reckon with.
inline constexpr Range kDirections{.min = -1e6, .max = 1e6};

/// How many elements a list may have.
struct Count {
  std::size_t min = 0;
  std::size_t max = std::numeric_limits<std::size_t>::max();
};

/// A row of the table behind an enum:
///     inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "quick"}, ...};
template <class Enum>
struct Choice {
  std::string_view name;
  Enum value;
  std::string_view doc;
};

class Reader;
class SchemaWriter;

/// A row of the table of the kinds that a T may be of. `describe(v, T&)` says what all kinds have in common
/// (it may be empty), the row what its kind has besides; the same name must not stand in both. The name
/// "kind" is taken.
template <class T>
struct Kind {
  std::string_view name;
  std::string_view doc;
  void (*read)(Reader&, T&);
  void (*schema)(SchemaWriter&);
};

/// The names of the three properties of a list with defaults: each element is merged with the object
/// `defaults` (merge(): its own wins) except for the properties that `force` lists. `defaults` may hold the
/// properties of any kind; an element passes over those that its kind does not have.
struct Inheritance {
  std::string_view list = "organisms";
  std::string_view defaults = "defaults";
  std::string_view force = "force";
  std::string_view instead = "species";  ///< an element that gives it need not say its kind
};

/// The type that a property is read as: T itself, or what is in the std::optional.
template <class T>
struct HeldType {
  using type = T;
};
template <class T>
struct HeldType<std::optional<T>> {
  using type = T;
};
template <class T>
using Held = typename HeldType<T>::type;

}  // namespace frond
