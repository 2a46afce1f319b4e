#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace frond {

// How a parameter struct is described
// ===================================
// One function template beside the struct is enough: it is used to read the struct from JSON (Reader) and to
// print the schema (SchemaWriter), and so the documentation, and to make its keys (KeyWriter), by which what
// is made from it is found again. The struct's initial values are the defaults.
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
// It is called with a new struct to fill, or with the defaults to print, and must do nothing else with them.
// Names and docs are string literals. Every visitor has:
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
//     aspect(aspect)                       what the properties after this line tell (Aspect, below); without
//                                          it they tell what the object that holds them does, at first shape
//     aspect(aspect, names...)             what these properties tell; after the lines that read them
//     custom(name, x, read, schema, doc)   all else: `bool read(Reader&, const Value&, X&)` notes faults by
//                                          Reader::fault and says whether x was read; `schema` is JSON text
//
// Each that reads a property also takes a std::optional of its type, which stays empty where it is not given.
// The doc says what a property is, range.unit in which unit; both stand in the schema.
//
// What of a value counts in its keys besides its properties, or is custom, is added by a function beside it:
// `void describe_rest(KeyWriter&, X&)`.

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

class Reader;
class SchemaWriter;
class KeyWriter;

/// A row of the table of kinds of a T. `describe(v, T&)` gives the properties common to all kinds (it may be
/// empty), the row those of its kind; no name may be in both. The name "kind" is reserved.
template <class T>
struct Kind {
  std::string_view name;
  std::string_view doc;
  void (*read)(Reader&, T&);
  void (*schema)(SchemaWriter&);
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

/// The type of a property: T itself, or the content type of the std::optional.
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
