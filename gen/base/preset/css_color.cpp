#include "preset/css_color.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/read_as.h"
#include "core/text.h"

namespace frond {
namespace {

// The named colours of CSS Color 4, section 6.1.
constexpr std::pair<std::string_view, unsigned> kCssNames[] = {{"aliceblue", 0xf0f8ff},
                                                               {"antiquewhite", 0xfaebd7},
                                                               {"aqua", 0x00ffff},
                                                               {"aquamarine", 0x7fffd4},
                                                               {"azure", 0xf0ffff},
                                                               {"beige", 0xf5f5dc},
                                                               {"bisque", 0xffe4c4},
                                                               {"black", 0x000000},
                                                               {"blanchedalmond", 0xffebcd},
                                                               {"blue", 0x0000ff},
                                                               {"blueviolet", 0x8a2be2},
                                                               {"brown", 0xa52a2a},
                                                               {"burlywood", 0xdeb887},
                                                               {"cadetblue", 0x5f9ea0},
                                                               {"chartreuse", 0x7fff00},
                                                               {"chocolate", 0xd2691e},
                                                               {"coral", 0xff7f50},
                                                               {"cornflowerblue", 0x6495ed},
                                                               {"cornsilk", 0xfff8dc},
                                                               {"crimson", 0xdc143c},
                                                               {"cyan", 0x00ffff},
                                                               {"darkblue", 0x00008b},
                                                               {"darkcyan", 0x008b8b},
                                                               {"darkgoldenrod", 0xb8860b},
                                                               {"darkgray", 0xa9a9a9},
                                                               {"darkgreen", 0x006400},
                                                               {"darkgrey", 0xa9a9a9},
                                                               {"darkkhaki", 0xbdb76b},
                                                               {"darkmagenta", 0x8b008b},
                                                               {"darkolivegreen", 0x556b2f},
                                                               {"darkorange", 0xff8c00},
                                                               {"darkorchid", 0x9932cc},
                                                               {"darkred", 0x8b0000},
                                                               {"darksalmon", 0xe9967a},
                                                               {"darkseagreen", 0x8fbc8f},
                                                               {"darkslateblue", 0x483d8b},
                                                               {"darkslategray", 0x2f4f4f},
                                                               {"darkslategrey", 0x2f4f4f},
                                                               {"darkturquoise", 0x00ced1},
                                                               {"darkviolet", 0x9400d3},
                                                               {"deeppink", 0xff1493},
                                                               {"deepskyblue", 0x00bfff},
                                                               {"dimgray", 0x696969},
                                                               {"dimgrey", 0x696969},
                                                               {"dodgerblue", 0x1e90ff},
                                                               {"firebrick", 0xb22222},
                                                               {"floralwhite", 0xfffaf0},
                                                               {"forestgreen", 0x228b22},
                                                               {"fuchsia", 0xff00ff},
                                                               {"gainsboro", 0xdcdcdc},
                                                               {"ghostwhite", 0xf8f8ff},
                                                               {"gold", 0xffd700},
                                                               {"goldenrod", 0xdaa520},
                                                               {"gray", 0x808080},
                                                               {"green", 0x008000},
                                                               {"greenyellow", 0xadff2f},
                                                               {"grey", 0x808080},
                                                               {"honeydew", 0xf0fff0},
                                                               {"hotpink", 0xff69b4},
                                                               {"indianred", 0xcd5c5c},
                                                               {"indigo", 0x4b0082},
                                                               {"ivory", 0xfffff0},
                                                               {"khaki", 0xf0e68c},
                                                               {"lavender", 0xe6e6fa},
                                                               {"lavenderblush", 0xfff0f5},
                                                               {"lawngreen", 0x7cfc00},
                                                               {"lemonchiffon", 0xfffacd},
                                                               {"lightblue", 0xadd8e6},
                                                               {"lightcoral", 0xf08080},
                                                               {"lightcyan", 0xe0ffff},
                                                               {"lightgoldenrodyellow", 0xfafad2},
                                                               {"lightgray", 0xd3d3d3},
                                                               {"lightgreen", 0x90ee90},
                                                               {"lightgrey", 0xd3d3d3},
                                                               {"lightpink", 0xffb6c1},
                                                               {"lightsalmon", 0xffa07a},
                                                               {"lightseagreen", 0x20b2aa},
                                                               {"lightskyblue", 0x87cefa},
                                                               {"lightslategray", 0x778899},
                                                               {"lightslategrey", 0x778899},
                                                               {"lightsteelblue", 0xb0c4de},
                                                               {"lightyellow", 0xffffe0},
                                                               {"lime", 0x00ff00},
                                                               {"limegreen", 0x32cd32},
                                                               {"linen", 0xfaf0e6},
                                                               {"magenta", 0xff00ff},
                                                               {"maroon", 0x800000},
                                                               {"mediumaquamarine", 0x66cdaa},
                                                               {"mediumblue", 0x0000cd},
                                                               {"mediumorchid", 0xba55d3},
                                                               {"mediumpurple", 0x9370db},
                                                               {"mediumseagreen", 0x3cb371},
                                                               {"mediumslateblue", 0x7b68ee},
                                                               {"mediumspringgreen", 0x00fa9a},
                                                               {"mediumturquoise", 0x48d1cc},
                                                               {"mediumvioletred", 0xc71585},
                                                               {"midnightblue", 0x191970},
                                                               {"mintcream", 0xf5fffa},
                                                               {"mistyrose", 0xffe4e1},
                                                               {"moccasin", 0xffe4b5},
                                                               {"navajowhite", 0xffdead},
                                                               {"navy", 0x000080},
                                                               {"oldlace", 0xfdf5e6},
                                                               {"olive", 0x808000},
                                                               {"olivedrab", 0x6b8e23},
                                                               {"orange", 0xffa500},
                                                               {"orangered", 0xff4500},
                                                               {"orchid", 0xda70d6},
                                                               {"palegoldenrod", 0xeee8aa},
                                                               {"palegreen", 0x98fb98},
                                                               {"paleturquoise", 0xafeeee},
                                                               {"palevioletred", 0xdb7093},
                                                               {"papayawhip", 0xffefd5},
                                                               {"peachpuff", 0xffdab9},
                                                               {"peru", 0xcd853f},
                                                               {"pink", 0xffc0cb},
                                                               {"plum", 0xdda0dd},
                                                               {"powderblue", 0xb0e0e6},
                                                               {"purple", 0x800080},
                                                               {"rebeccapurple", 0x663399},
                                                               {"red", 0xff0000},
                                                               {"rosybrown", 0xbc8f8f},
                                                               {"royalblue", 0x4169e1},
                                                               {"saddlebrown", 0x8b4513},
                                                               {"salmon", 0xfa8072},
                                                               {"sandybrown", 0xf4a460},
                                                               {"seagreen", 0x2e8b57},
                                                               {"seashell", 0xfff5ee},
                                                               {"sienna", 0xa0522d},
                                                               {"silver", 0xc0c0c0},
                                                               {"skyblue", 0x87ceeb},
                                                               {"slateblue", 0x6a5acd},
                                                               {"slategray", 0x708090},
                                                               {"slategrey", 0x708090},
                                                               {"snow", 0xfffafa},
                                                               {"springgreen", 0x00ff7f},
                                                               {"steelblue", 0x4682b4},
                                                               {"tan", 0xd2b48c},
                                                               {"teal", 0x008080},
                                                               {"thistle", 0xd8bfd8},
                                                               {"tomato", 0xff6347},
                                                               {"turquoise", 0x40e0d0},
                                                               {"violet", 0xee82ee},
                                                               {"wheat", 0xf5deb3},
                                                               {"white", 0xffffff},
                                                               {"whitesmoke", 0xf5f5f5},
                                                               {"yellow", 0xffff00},
                                                               {"yellowgreen", 0x9acd32}};

Color of_code(unsigned code) {
  auto channel = [&](int shift) { return static_cast<float>(code >> shift & 0xff) / 255.0f; };
  return {channel(16), channel(8), channel(0)};
}

/// The digits after the #: three or six.
std::optional<Color> of_digits(std::string_view digits) {
  unsigned code = 0;
  const char* end = digits.data() + digits.size();
  if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
  if (auto [stop, wrong] = std::from_chars(digits.data(), end, code, 16); wrong != std::errc() || stop != end)
    return std::nullopt;
  if (digits.size() == 6) return of_code(code);
  return of_code((code >> 8 & 0xf) * 0x110000 + (code >> 4 & 0xf) * 0x1100 + (code & 0xf) * 0x11);
}

/// A number with its unit: "50%" is {50, "%"}.
using Argument = std::pair<double, std::string_view>;

/// What stands between the brackets: three arguments with commas or blanks between them.
std::optional<std::array<Argument, 3>> arguments_of(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  std::array<Argument, 3> arguments;
  bool commas = text.find(',') != text.npos;
  auto skip = [&] { text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size())); };
  for (std::size_t i = 0; i < 3; ++i) {
    skip();
    if (i > 0 && commas) {
      if (!text.starts_with(',')) return std::nullopt;
      text.remove_prefix(1);
      skip();
    }
    std::optional<double> number = consume_as<double>(text);
    if (!number) return std::nullopt;
    arguments[i].first = *number;
    std::size_t end = std::min(text.find_first_of(", \t"), text.size());
    arguments[i].second = text.substr(0, end);
    text.remove_prefix(end);
  }
  skip();
  return text.empty() ? std::optional(arguments) : std::nullopt;
}

/// A share from 0 to 1, of a percentage.
bool is_share(const Argument& a) { return a.second == "%" && a.first >= 0 && a.first <= 100; }

std::optional<Color> of_rgb(const std::array<Argument, 3>& arguments) {
  std::array<float, 3> channels;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [number, unit] = arguments[i];
    if (unit != arguments[0].second ||
        !(is_share(arguments[i]) || (unit.empty() && number >= 0 && number <= 255)))
      return std::nullopt;
    channels[i] = static_cast<float>(number / (unit.empty() ? 255 : 100));
  }
  return Color{channels[0], channels[1], channels[2]};
}

/// CSS Color 4, section 7.1: the hue in degrees, saturation and lightness as percentages.
std::optional<Color> of_hsl(const std::array<Argument, 3>& arguments) {
  double hue = arguments[0].first;
  const auto& unit = arguments[0].second;
  if ((!unit.empty() && unit != "deg") || !is_share(arguments[1]) || !is_share(arguments[2]))
    return std::nullopt;
  double lightness = arguments[2].first / 100;
  double half = arguments[1].first / 100 * std::min(lightness, 1 - lightness);
  auto channel = [&](double n) {
    double k = glm::mod(n + hue / 30, 12.0);
    return static_cast<float>(lightness - half * std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0));
  };
  return Color{channel(0), channel(8), channel(4)};
}

}  // namespace

std::optional<Color> css_color(std::string_view text) {
  if (text.starts_with('#')) return of_digits(text.substr(1));
  std::string low = lower_case(text);
  if (low.ends_with(')') && (low.starts_with("rgb(") || low.starts_with("hsl("))) {
    auto arguments = arguments_of(std::string_view(low).substr(4, low.size() - 5));
    if (!arguments) return std::nullopt;
    return low[0] == 'r' ? of_rgb(*arguments) : of_hsl(*arguments);
  }
  auto named = std::ranges::find(kCssNames, low, [](const auto& row) { return row.first; });
  return named == std::end(kCssNames) ? std::nullopt : std::optional(of_code(named->second));
}

std::string_view nearest_css_name(std::string_view text) {
  std::array<std::string_view, std::size(kCssNames)> names;
  std::ranges::transform(kCssNames, names.begin(), [](const auto& row) { return row.first; });
  return nearest_name(text.substr(0, 64), names);
}

}  // namespace frond
