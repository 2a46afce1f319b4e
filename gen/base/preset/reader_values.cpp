#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "preset/css_color.h"
#include "preset/eases.h"
#include "preset/range_text.h"
#include "preset/reader.h"

namespace frond {
namespace {

constexpr std::string_view kKeyframes = "keyframes [[seconds, value], ...]";

/// Two keyframes or points must be in order; `before` and `after` as they are stored.
std::string order_text(std::string_view what, double before) {
  return fmt::format("{} greater than {} before it", what, serialize(make_number(before)));
}

}  // namespace

std::optional<double> Reader::number_at(const Value& value, const Range& range) {
  if (value.is(Value::Type::number) && range.holds(value.number)) return value.number;
  bool large = value.is(Value::Type::number) && std::abs(value.number) > std::numeric_limits<float>::max();
  return fault(value, "a number" + (large ? " within 3.4e38" : range_text(range)));
}

std::optional<double> Reader::whole_at(const Value& value, const Range& range) {
  bool whole = value.is(Value::Type::number) && std::floor(value.number) == value.number;
  if (whole && range.holds(value.number)) return value.number;
  return fault(value, "a whole number" + range_text(range));
}

std::optional<bool> Reader::boolean_at(const Value& value) {
  if (value.is(Value::Type::boolean)) return value.boolean;
  return fault(value, "true or false");
}

std::optional<std::string> Reader::text_at(const Value& value) {
  if (value.is(Value::Type::text)) return value.text;
  return fault(value, "a text");
}

std::optional<std::size_t> Reader::name_at(const Value& value, std::span<const std::string_view> names) {
  auto named = std::ranges::find(names, value.text);
  if (value.is(Value::Type::text) && named != names.end())
    return static_cast<std::size_t>(named - names.begin());
  faults_.add({value.origin, pointer_, "found " + found_text(value) + expected_names(value.text, names)});
  return std::nullopt;
}

bool Reader::numbers_at(const Value& value, const Range& range, std::span<double> out) {
  if (!value.is(Value::Type::list) || value.items.size() != out.size()) {
    fault(value, fmt::format("a list of {} numbers{}", out.size(), range_text(range)));
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < out.size(); ++i) {
    auto number = inside(std::to_string(i), [&] { return number_at(value.items[i], range); });
    if (number) out[i] = *number;
    good = good && number;
  }
  return good;
}

bool Reader::has_length(const Value& value, const DVec3& direction, Across across) {
  constexpr double kShortest = 1e-3;  // what is much shorter is written as 0
  DVec3 counts = across == Across::all ? direction : DVec3(direction.x, 0, direction.z);
  if (glm::length(counts) >= kShortest) return true;
  faults_.add({value.origin, pointer_,
               fmt::format("found {}; expected a direction{} of length {} or more", serialize(value),
                           across == Across::all ? "" : " along x and z", kShortest)});
  return false;
}

std::optional<std::array<int, 2>> Reader::size_at(const Value& value, const Range& range) {
  if (!value.is(Value::Type::list) || value.items.size() != 2) return fault(value, "[width, height]");
  std::array<int, 2> size{};
  bool wide = inside("0", [&] { return integer_at(value.items[0], range, slot_of(size[0])); });
  bool high = inside("1", [&] { return integer_at(value.items[1], range, slot_of(size[1])); });
  return wide && high ? std::optional(size) : std::nullopt;
}

std::optional<Color> Reader::color_at(const Value& value) {
  if (value.is(Value::Type::list)) {
    auto rgb = vector_at<Vec3>(value, kShare);
    return rgb ? std::optional(Color{rgb->x, rgb->y, rgb->z}) : std::nullopt;
  }
  std::string_view near;
  if (value.is(Value::Type::text)) {
    if (std::optional<Color> color = css_color(value.text)) return color;
    near = nearest_css_name(value.text);
  }
  std::string meant = near.empty() ? "" : fmt::format("; did you mean \"{}\"?", near);
  return fault(value,
               "a color: a name of CSS, \"#rrggbb\", rgb(), hsl() or [red, green, blue] from 0 to 1" + meant);
}

std::optional<Curve> Reader::curve_at(const Value& value) {
  if (!value.is(Value::Type::list) || value.items.size() < 2)
    return fault(value, "a curve: two or more points [[x, y], ...]");
  std::vector<Vec2> points;
  bool good = true;
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    auto point = inside(std::to_string(i), [&] { return vector_at<Vec2>(value.items[i], {}); });
    if (good && point && !points.empty() && point->x <= points.back().x) {
      double before = value.items[i - 1].items[0].number;
      const Value& x = value.items[i].items[0];
      inside(std::to_string(i), [&] { inside("0", [&] { fault(x, order_text("an x", before)); }); });
      good = false;
    }
    good = good && point;
    if (!good) continue;
    points.push_back(*point);
  }
  return good ? std::optional(Curve(std::move(points))) : std::nullopt;
}

template <class T, class Read>
std::optional<Animated<T>> Reader::keys_at(const Value& value, bool constant, Read read) {
  if (constant) {
    auto still = read(value);
    return still ? std::optional(Animated<T>(*still)) : std::nullopt;
  }
  std::vector<typename Animated<T>::Key> keys;
  bool good = true;
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    const Value& item = value.items[i];
    inside(std::to_string(i), [&] {
      if (!item.is(Value::Type::list) || item.items.size() < 2 || item.items.size() > 3) {
        fault(item, "a keyframe [seconds, value] or [seconds, value, ease]");
        good = false;
        return;
      }
      auto time = inside("0", [&] { return number_at(item.items[0], {}); });
      auto key = inside("1", [&] { return read(item.items[1]); });
      if (time && !keys.empty() && *time <= keys.back().time) {
        inside("0", [&] { fault(item.items[0], order_text("a time", keys.back().time)); });
        good = false;
      }
      KeyShape<T> shape;
      if (item.items.size() > 2) good &= inside("2", [&] { return object_at(item.items[2], shape); });
      good = good && time && key;
      if (time) keys.push_back({*time, key ? *key : T{}, shape.ease, shape.in, shape.out});
    });
  }
  return good ? std::optional(Animated<T>(std::move(keys))) : std::nullopt;
}

std::optional<Animated<double>> Reader::animated_at(const Value& value, const Range& range,
                                                    const Animated<double>&) {
  bool list = value.is(Value::Type::list) && !value.items.empty();
  if (!list && !value.is(Value::Type::number))
    return fault(value, fmt::format("a number{}, or {}", range_text(range), kKeyframes));
  return keys_at<double>(value, !list, [&](const Value& v) { return number_at(v, range); });
}

std::optional<Animated<Vec3>> Reader::animated_at(const Value& value, const Range& range,
                                                  const Animated<Vec3>&) {
  if (!value.is(Value::Type::list) || value.items.empty())
    return fault(value, fmt::format("a list of 3 numbers{}, or {}", range_text(range), kKeyframes));
  bool constant = !value.items[0].is(Value::Type::list);
  return keys_at<Vec3>(value, constant, [&](const Value& v) { return vector_at<Vec3>(v, range); });
}

std::optional<std::vector<std::pair<std::string, std::string>>> Reader::pairs_at(const Value& value) {
  if (!value.is(Value::Type::object)) return fault(value, "an object of numbers and texts");
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const Member& member : value.members) {
    const Value& inner = member.value;
    if (inner.is(Value::Type::text)) {
      pairs.emplace_back(member.name, inner.text);
    } else if (inner.is(Value::Type::number)) {
      pairs.emplace_back(member.name, serialize(inner));
    } else {
      inside(member.name, [&] { fault(inner, "a number or a text"); });
    }
  }
  return pairs;
}

}  // namespace frond
