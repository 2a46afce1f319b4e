#include "core/text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "core/read_as.h"

namespace frond {

void append(std::string& text, double value, int decimals) {
  static constexpr std::array<long long, 10> kPower{
      1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
  assert(decimals >= 0 && decimals <= 9);
  // As one whole number of the last decimal: integers convert several times faster than floating point.
  long long power = kPower[decimals];
  double product = value * static_cast<double>(power);
  if (!(std::abs(product) < 9e18)) product = std::isnan(value) ? 0 : std::copysign(9e18, value);
  long long scaled = std::llround(product);
  char buffer[32];
  char* out = buffer;
  if (scaled < 0) {
    *out++ = '-';
    scaled = -scaled;
  }
  out = std::to_chars(out, buffer + sizeof buffer, scaled / power).ptr;
  if (long long fraction = scaled % power) {
    *out++ = '.';
    for (long long rest = power / 10; rest > fraction; rest /= 10) *out++ = '0';
    while (fraction % 10 == 0) fraction /= 10;
    out = std::to_chars(out, buffer + sizeof buffer, fraction).ptr;
  }
  text.append(buffer, out);
}

std::string number_text(double value, int decimals) {
  std::string text;
  append(text, value, decimals);
  return text;
}

void append_integer(std::string& text, long long value) {
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::string lower_case(std::string_view text) {
  std::string low(text);
  std::ranges::transform(low, low.begin(), lower);
  return low;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t change = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
      bool swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

int counting_number(std::string_view text) { return std::max(read_as<int>(text).value_or(0), 0); }

int consume_whole(std::string_view& text) {
  std::string_view rest = text;
  int number = consume_as<int>(rest).value_or(-1);
  if (number < 0) return 0;
  text = rest;
  return number;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    std::size_t end = std::min(text.find(separator), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

}  // namespace frond
