#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/curve.h"
#include "core/function_ref.h"
#include "core/vec.h"

namespace frond {

class KeyWriter;
class Properties;
struct Keys;
struct SlotType;

/// A value that a property stands for, of any of the types that properties may have (describe.h). So visitors
/// are compiled once, and not for each type.
struct Slot {
  void* at = nullptr;
  const SlotType* type = nullptr;

  /// The type of what an optional may hold; for all else the slot's own type.
  const SlotType& held_type() const;
  /// The value that an optional holds, or nothing if it is empty; for all else the slot itself.
  std::optional<Slot> held() const;
  /// The value that an optional holds, made if it is empty; for all else the slot itself.
  Slot hold() const;

  template <class T>
  T& as() const {
    return *static_cast<T*>(at);
  }
};

/// The type of a slot, and how its values are handled. Functions take the address of a value.
struct SlotType {
  enum class Kind {
    boolean,
    real,      ///< float or double
    integer,   ///< of any width
    text,      ///< std::string
    choice,    ///< an enum, or the index of a row
    vector,    ///< Vec2, DVec2, Vec3, DVec3
    size,      ///< std::array<int, 2>
    color,     ///< Color
    curve,     ///< Curve
    animated,  ///< Animated<double>, Animated<Vec3>
    pairs,     ///< std::vector<std::pair<std::string, std::string>>
    keys,      ///< Keys
    list,      ///< std::vector of any of these
    optional,  ///< std::optional of any of these
    object     ///< a struct that is described
  };

  Kind kind;

  // Numbers, and components of vectors:
  bool is_float = false;     ///< not double
  bool is_unsigned = false;  ///< of integers
  int length = 1;            ///< how many there are; of what is animated, too
  double lowest = 0, highest = 0;
  double (*get)(const void*) = nullptr;        ///< of integers
  void (*set)(void*, double whole) = nullptr;  ///< of integers

  // Lists, and an optional as a list of at most one element:
  const SlotType* element = nullptr;
  std::size_t (*count)(const void*) = nullptr;
  void* (*element_at)(void*, std::size_t) = nullptr;
  void (*clear)(void*) = nullptr;
  void* (*add)(void*) = nullptr;  ///< an element with its initial value

  // Objects:
  void (*describe)(Properties&, void*) = nullptr;
  void (*rest)(KeyWriter&, void*) = nullptr;  ///< describe_rest(), if it has one
  /// Calls `work` with an object with its initial values.
  void (*with_sample)(FunctionRef<void(Slot)> work) = nullptr;
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

namespace slots {

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

}  // namespace slots

template <class T>
constexpr SlotType::Kind slot_kind() {
  using Kind = SlotType::Kind;
  if (std::is_same_v<T, bool>) return Kind::boolean;
  if (std::is_floating_point_v<T>) return Kind::real;
  if (std::is_integral_v<T>) return Kind::integer;
  if (std::is_same_v<T, std::string>) return Kind::text;
  if (std::is_enum_v<T>) return Kind::choice;
  if (std::is_same_v<T, std::array<int, 2>>) return Kind::size;
  if (std::is_same_v<T, Color>) return Kind::color;
  if (std::is_same_v<T, Curve>) return Kind::curve;
  if (std::is_same_v<T, Animated<double>> || std::is_same_v<T, Animated<Vec3>>) return Kind::animated;
  if (std::is_same_v<T, std::vector<std::pair<std::string, std::string>>>) return Kind::pairs;
  if (std::is_same_v<T, Keys>) return Kind::keys;
  if (slots::is_vector<T>) return Kind::list;
  if (slots::is_optional<T>) return Kind::optional;
  return requires { T::length(), typename T::value_type(); }
  ? Kind::vector : Kind::object;
}

template <class T>
constexpr SlotType make_slot_type();

/// The one of T.
template <class T>
inline constexpr SlotType slot_type = make_slot_type<T>();

template <class T>
constexpr void set_limits(SlotType& type) {
  constexpr double kExact = 9007199254740992.0;  // not all integers beyond 2^53 are doubles
  type.lowest = static_cast<double>(std::numeric_limits<T>::lowest());
  type.highest = static_cast<double>(std::numeric_limits<T>::max());
  if (!std::is_integral_v<T>) return;
  type.lowest = std::max(type.lowest, -kExact);
  type.highest = std::min(type.highest, kExact);
}

template <class T>
constexpr SlotType make_slot_type() {
  using Kind = SlotType::Kind;
  SlotType type{slot_kind<T>()};
  if constexpr (slot_kind<T>() == Kind::real) {
    type.is_float = std::is_same_v<T, float>;
    set_limits<T>(type);
  } else if constexpr (slot_kind<T>() == Kind::integer) {
    type.is_unsigned = std::is_unsigned_v<T>;
    set_limits<T>(type);
    type.get = [](const void* n) { return static_cast<double>(*static_cast<const T*>(n)); };
    type.set = [](void* n, double whole) { *static_cast<T*>(n) = static_cast<T>(whole); };
  } else if constexpr (slot_kind<T>() == Kind::vector) {
    type.is_float = std::is_same_v<typename T::value_type, float>;
    type.length = T::length();
    set_limits<typename T::value_type>(type);
  } else if constexpr (slot_kind<T>() == Kind::animated) {
    type.length = std::is_same_v<T, Animated<Vec3>> ? 3 : 1;
  } else if constexpr (slot_kind<T>() == Kind::list) {
    type.element = &slot_type<typename T::value_type>;
    type.count = [](const void* l) { return static_cast<const T*>(l)->size(); };
    type.element_at = [](void* l, std::size_t i) -> void* { return static_cast<T*>(l)->data() + i; };
    type.clear = [](void* l) { static_cast<T*>(l)->clear(); };
    type.add = [](void* l) -> void* { return &static_cast<T*>(l)->emplace_back(); };
  } else if constexpr (slot_kind<T>() == Kind::optional) {
    type.element = &slot_type<typename T::value_type>;
    type.count = [](const void* o) -> std::size_t { return static_cast<const T*>(o)->has_value(); };
    type.element_at = [](void* o, std::size_t) -> void* { return &**static_cast<T*>(o); };
    type.clear = [](void* o) { static_cast<T*>(o)->reset(); };
    type.add = [](void* o) -> void* { return &static_cast<T*>(o)->emplace(); };
  } else if constexpr (slot_kind<T>() == Kind::object) {
    constexpr bool has_properties = requires(Properties & v, T & object) { describe(v, object); };
    constexpr bool has_rest = requires(KeyWriter & v, T & object) { describe_rest(v, object); };
    static_assert(has_properties || has_rest, "nothing says what of it counts");
    if constexpr (has_properties)
      type.describe = [](Properties& v, void* o) { describe(v, *static_cast<T*>(o)); };
    if constexpr (has_rest) type.rest = [](KeyWriter& v, void* o) { describe_rest(v, *static_cast<T*>(o)); };
    type.with_sample = [](FunctionRef<void(Slot)> work) {
      T sample{};
      work({&sample, &slot_type<T>});
    };
  }
  return type;
}

template <class T>
Slot slot_of(T& x) {
  return {&x, &slot_type<T>};
}

/// A slot of one kind, perhaps an optional of it.
template <SlotType::Kind kind>
struct SlotOf : Slot {
  template <class T>
  requires(!std::derived_from<T, Slot> && slot_kind<Held<T>>() == kind) SlotOf(T& x) : Slot(slot_of(x)) {}
};
using RealSlot = SlotOf<SlotType::Kind::real>;
using IntegerSlot = SlotOf<SlotType::Kind::integer>;
using BooleanSlot = SlotOf<SlotType::Kind::boolean>;
using TextSlot = SlotOf<SlotType::Kind::text>;
using VectorSlot = SlotOf<SlotType::Kind::vector>;
using SizeSlot = SlotOf<SlotType::Kind::size>;
using ColorSlot = SlotOf<SlotType::Kind::color>;
using CurveSlot = SlotOf<SlotType::Kind::curve>;
using AnimatedSlot = SlotOf<SlotType::Kind::animated>;
using PairsSlot = SlotOf<SlotType::Kind::pairs>;
using ListSlot = SlotOf<SlotType::Kind::list>;
using ObjectSlot = SlotOf<SlotType::Kind::object>;

/// A slot of any kind.
struct AnySlot : Slot {
  template <class T>
  requires(!std::derived_from<T, Slot>) AnySlot(T& x) : Slot(slot_of(x)) {}
};

inline const SlotType& Slot::held_type() const {
  return type->kind == SlotType::Kind::optional ? *type->element : *type;
}

inline std::optional<Slot> Slot::held() const {
  if (type->kind != SlotType::Kind::optional) return *this;
  if (type->count(at) == 0) return std::nullopt;
  return Slot{type->element_at(at, 0), type->element};
}

inline Slot Slot::hold() const {
  if (type->kind != SlotType::Kind::optional) return *this;
  return {type->count(at) ? type->element_at(at, 0) : type->add(at), type->element};
}

}  // namespace frond
