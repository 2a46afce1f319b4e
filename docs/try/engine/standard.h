#pragma once

// What the sources use of the C++20 library and the one of emscripten 3.1.6 (libc++ 13) does not have. Every
// source is compiled with this header included first.

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <version>

#if _LIBCPP_VERSION < 15000

namespace std {

/// Reads what std::strtod reads in the locale "C", as far as std::from_chars would: neither space, plus sign
/// nor hexadecimal digits, and in the fixed format no power.
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format format = chars_format::general) {
  const char* digits = first != last && *first == '-' ? first + 1 : first;
  auto is_digit = [&](const char* c) { return c < last && *c >= '0' && *c <= '9'; };
  bool number = is_digit(digits) || (digits < last && *digits == '.' && is_digit(digits + 1));
  if (!number) return {first, errc::invalid_argument};
  const char* end = digits;
  while (is_digit(end)) ++end;
  if (end < last && *end == '.') ++end;
  while (is_digit(end)) ++end;
  if (format != chars_format::fixed && end < last && (*end == 'e' || *end == 'E')) {
    const char* power = end + 1;
    if (power < last && (*power == '+' || *power == '-')) ++power;
    if (is_digit(power)) end = power;
    while (is_digit(end)) ++end;
  }
  errno = 0;
  double read = strtod(string(first, end).c_str(), nullptr);
  if (errno == ERANGE) return {end, errc::result_out_of_range};
  value = read;
  return {end, errc{}};
}

/// The fewest digits that read back as the same number. There must be room for them.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  auto room = static_cast<size_t>(last - first);
  int digits = 1, length = 0;
  do length = snprintf(first, room, "%.*e", digits - 1, value);
  while (strtod(first, nullptr) != value && ++digits <= 17);
  int power = atoi(strchr(first, 'e') + 1);
  length = format == chars_format::fixed ? snprintf(first, room, "%.*f", max(digits - 1 - power, 0), value)
                                         : snprintf(first, room, "%.*g", digits, value);
  return {first + length, errc{}};
}

/// The same of a number of single precision.
inline to_chars_result to_chars(char* first, char* last, float value) {
  auto room = static_cast<size_t>(last - first);
  int digits = 1, length = 0;
  do length = snprintf(first, room, "%.*g", digits, static_cast<double>(value));
  while (strtof(first, nullptr) != value && ++digits <= 9);
  return {first + length, errc{}};
}

namespace ranges {

/// A test of what a projection makes of an item. Both may be members.
template <class Test, class Projection>
auto of_each(const Test& test, const Projection& projection) {
  return [&](const auto& each) { return invoke(test, invoke(projection, each)); };
}

template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return find_if(begin(range), end(range),
                 [&](const auto& each) { return invoke(projection, each) == value; });
}
template <class Range, class Test, class Projection = identity>
auto find_if(Range&& range, Test test, Projection projection = {}) {
  return std::find_if(begin(range), end(range), of_each(test, projection));
}
template <class Range, class Test, class Projection = identity>
bool all_of(Range&& range, Test test, Projection projection = {}) {
  return std::all_of(begin(range), end(range), of_each(test, projection));
}
template <class Range, class Test, class Projection = identity>
bool any_of(Range&& range, Test test, Projection projection = {}) {
  return std::any_of(begin(range), end(range), of_each(test, projection));
}
template <class Range, class Test, class Projection = identity>
bool none_of(Range&& range, Test test, Projection projection = {}) {
  return std::none_of(begin(range), end(range), of_each(test, projection));
}
template <class Range, class Value>
void replace(Range&& range, const Value& from, const Value& to) {
  std::replace(begin(range), end(range), from, to);
}
template <class Range, class Test, class Value>
void replace_if(Range&& range, Test test, const Value& to) {
  std::replace_if(begin(range), end(range), test, to);
}
template <class Range, class Value, class Order = std::less<>, class Projection = identity>
auto lower_bound(Range&& range, const Value& value, Order order = {}, Projection projection = {}) {
  return std::lower_bound(begin(range), end(range), value, [&](const auto& each, const Value& sought) {
    return invoke(order, invoke(projection, each), sought);
  });
}
template <class Range, class Value>
void fill(Range&& range, const Value& value) {
  std::fill(begin(range), end(range), value);
}
template <class Range, class Value, class Projection = identity>
auto count(Range&& range, const Value& value, Projection projection = {}) {
  return std::count_if(begin(range), end(range),
                       [&](const auto& each) { return invoke(projection, each) == value; });
}
template <class One, class Other, class Out>
auto set_intersection(const One& one, const Other& other, Out to) {
  return std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), to);
}
template <class Range, class Value, class Order = std::less<>, class Projection = identity>
auto upper_bound(Range&& range, const Value& value, Order order = {}, Projection projection = {}) {
  return std::upper_bound(begin(range), end(range), value, [&](const Value& sought, const auto& each) {
    return invoke(order, sought, invoke(projection, each));
  });
}
template <class Range, class Value>
bool binary_search(Range&& range, const Value& value) {
  return std::binary_search(begin(range), end(range), value);
}
template <class Range, class Test, class Projection = identity>
auto count_if(Range&& range, Test test, Projection projection = {}) {
  return std::count_if(begin(range), end(range), of_each(test, projection));
}
template <class One, class Other, class Same>
bool equal(One&& one, Other&& other, Same same) {
  return std::equal(begin(one), end(one), begin(other), end(other), same);
}
template <class One, class Other>
struct in_in_result {
  One in1;
  Other in2;
};
template <class One, class Other>
auto mismatch(const One& one, const Other& other) {
  auto found = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
  return in_in_result<decltype(found.first), decltype(found.second)>{found.first, found.second};
}
template <class Range, class Out, class Map>
auto transform(Range&& range, Out to, Map map) {
  return std::transform(begin(range), end(range), to, map);
}
template <class Range, class Out>
auto move(Range&& range, Out to) {
  return std::move(begin(range), end(range), to);
}
template <class Range, class Order = std::less<>, class Projection = identity>
void sort(Range&& range, Order order = {}, Projection projection = {}) {
  std::sort(begin(range), end(range), [&](const auto& a, const auto& b) {
    return invoke(order, invoke(projection, a), invoke(projection, b));
  });
}
template <class Range>
void reverse(Range&& range) {
  std::reverse(begin(range), end(range));
}
template <class Range, class Order = std::less<>, class Projection = identity>
auto min_element(Range&& range, Order order = {}, Projection projection = {}) {
  return std::min_element(begin(range), end(range), [&](const auto& a, const auto& b) {
    return order(invoke(projection, a), invoke(projection, b));
  });
}
template <class Range, class Order = std::less<>, class Projection = identity>
auto max_element(Range&& range, Order order = {}, Projection projection = {}) {
  return std::max_element(begin(range), end(range), [&](const auto& a, const auto& b) {
    return order(invoke(projection, a), invoke(projection, b));
  });
}
template <class Range, class Order = std::less<>, class Projection = identity>
auto max(const Range& range, Order order = {}, Projection projection = {}) {
  return *ranges::max_element(range, order, projection);
}
template <class Range, class Order = std::less<>, class Projection = identity>
auto min(const Range& range, Order order = {}, Projection projection = {}) {
  return *ranges::min_element(range, order, projection);
}
template <class Range, class Order = std::less<>, class Projection>
void stable_sort(Range&& range, Order, Projection projection) {
  std::stable_sort(begin(range), end(range), [&](const auto& a, const auto& b) {
    return invoke(projection, a) < invoke(projection, b);
  });
}

}  // namespace ranges

}  // namespace std

#endif
