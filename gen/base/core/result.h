#pragma once

#include <fmt/format.h>

#include <cassert>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace frond {

/// A mistake of the user or a failure of the machine: where it is (`file:line:col: /json/pointer`, or empty),
/// and what was found and expected. Our own mistakes are asserts.
struct Error {
  std::string where;
  std::string what;

  /// One line, `where: what`.
  std::string text() const { return where.empty() ? what : where + ": " + what; }
};

/// The error at a place, told as fmt::format() formats it.
template <class... Parts>
Error error_at(std::string where, fmt::format_string<Parts...> what, Parts&&... parts) {
  return {std::move(where), fmt::format(what, std::forward<Parts>(parts)...)};
}

using Errors = std::vector<Error>;

/// A value, or the reasons for its absence (at least one).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : held_(std::move(value)) {}
  Result(Error error) : held_(Errors{std::move(error)}) {}
  Result(Errors errors) : held_(std::move(errors)) { assert(!this->errors().empty()); }

  bool ok() const { return held_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() { return assert(ok()), std::get<0>(held_); }
  const T& value() const { return assert(ok()), std::get<0>(held_); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Errors& errors() const { return assert(!ok()), std::get<1>(held_); }

 private:
  std::variant<T, Errors> held_;
};

}  // namespace frond
