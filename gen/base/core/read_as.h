#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace frond {

/// Consumes a number at the front of a text, in the form that std::from_chars() reads; none where there is
/// none.
template <class Number>
std::optional<Number> consume_as(std::string_view& text) {
  Number number{};
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// The number that a whole text is; none where it is none.
template <class Number>
std::optional<Number> read_as(std::string_view text) {
  std::optional<Number> number = consume_as<Number>(text);
  return text.empty() ? number : std::nullopt;
}

}  // namespace frond
