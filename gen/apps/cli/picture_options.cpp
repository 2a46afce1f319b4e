#include "cli/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/read_as.h"
#include "preset/range_text.h"
#include "scene/describe.h"

namespace frond {

namespace {

constexpr double kUsualDpi = 300;
constexpr Range kDpi{.min = 1, .max = 10000};

/// Consumes a number above 0 at the front of a text; 0 where there is none.
double consume_length(std::string_view& text) {
  double number = consume_as<double>(text).value_or(0);
  return number > 0 ? number : 0;
}

bool consume_sign(std::string_view& text, std::string_view sign) {
  if (!text.starts_with(sign)) return false;
  text.remove_prefix(sign.size());
  return true;
}

/// Inches of a unit; 0 where it is none.
double inches(std::string_view unit) {
  return unit == "cm" ? 1 / 2.54 : unit == "mm" ? 1 / 25.4 : unit == "in" ? 1 : 0;
}

/// Consumes a number of pixels, or per cent of `whole`, at the front of a text; negative where there is none.
int consume_pixels(std::string_view& text, int whole) {
  double number = consume_as<double>(text).value_or(-1);
  if (!(number >= 0 && number <= 1e6)) return -1;
  if (consume_sign(text, "%")) number *= whole / 100.0;
  return static_cast<int>(std::lround(number));
}

Result<PixelRect> asked_crop(const std::string& asked, const std::array<int, 2>& size) {
  PixelRect crop;
  std::string_view rest = asked;
  bool good = (crop.x = consume_pixels(rest, size[0])) >= 0 && consume_sign(rest, ",") &&
              (crop.y = consume_pixels(rest, size[1])) >= 0 && consume_sign(rest, ",") &&
              (crop.width = consume_pixels(rest, size[0])) >= 0 && consume_sign(rest, "x") &&
              (crop.height = consume_pixels(rest, size[1])) >= 0 && rest.empty();
  if (!good)
    return Error{"--crop",
                 fmt::format("\"{}\" is no part of a picture; expected X,Y,WIDTHxHEIGHT in pixels or per "
                             "cent, as in 10,20,300x200 or 25%,25%,50%x50%",
                             asked)};
  if (crop.width < 1 || crop.height < 1 || crop.x + crop.width > size[0] || crop.y + crop.height > size[1])
    return Error{"--crop",
                 fmt::format("{},{},{}x{} pixels do not lie within the picture; expected a part of {}x{}",
                             crop.x, crop.y, crop.width, crop.height, size[0], size[1])};
  return crop;
}

}  // namespace

Result<std::string> printed_size(const PresetArguments& arguments, const Film& film) {
  if (arguments.size || arguments.scale)
    return Error{"--print", fmt::format("says the size, as {} does; expected one of the two",
                                        arguments.size ? "--size" : "--scale")};
  std::string_view rest = *arguments.print;
  double first = consume_length(rest), second = consume_sign(rest, "x") ? consume_length(rest) : -1,
         unit = inches(rest);
  if (first == 0 || second == 0 || unit == 0)
    return Error{"--print",
                 fmt::format("\"{}\" is no size on paper; expected one as 20cm, 20x15cm, 150mm or 8in",
                             *arguments.print)};
  double dots = arguments.dpi.value_or(kUsualDpi) * unit;
  bool wide = film.size[0] >= film.size[1];
  double shape = film.aspect(), width = first, height = second;
  if (second < 0) width = wide ? first : first / shape, height = wide ? first * shape : first;
  width = std::round(width * dots), height = std::round(height * dots);
  if (!kSides.holds(width) || !kSides.holds(height))
    return Error{"--print", fmt::format("found {}, {:g}x{:g} pixels; expected sides{}", *arguments.print,
                                        width, height, range_text(kSides))};
  return fmt::format("/film/size=[{:.0f},{:.0f}]", width, height);
}

Errors set_pictures(const PresetArguments& arguments, Film& film) {
  if (arguments.dpi && !kDpi.holds(*arguments.dpi))
    return {{"--dpi", fmt::format("found {:g}; expected a number{}", *arguments.dpi, range_text(kDpi))}};
  if (arguments.print || arguments.dpi) film.dpi = arguments.dpi.value_or(kUsualDpi);
  film.depth = arguments.depth.value_or(film.depth);
  if (!arguments.crop) return {};
  Result<PixelRect> crop = asked_crop(*arguments.crop, film.size);
  if (!crop) return crop.errors();
  film.crop = *crop;
  return {};
}

}  // namespace frond
