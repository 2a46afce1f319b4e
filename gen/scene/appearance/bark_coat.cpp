#include "appearance/bark_coat.h"

#include <fmt/format.h>

#include <cmath>

#include "appearance/describe.h"
#include "appearance/photographs.h"
#include "core/content.h"
#include "images/bark_photo.h"
#include "preset/keys.h"

namespace frond {

namespace {

std::string name_of(const BarkCoat& coat, std::string_view what) {
  std::string key = keys_of(coat.image, coat.photo.content, coat.aspect, coat.pixels).all();
  return fmt::format("bark_{}_{}.png", made_id(key), what);
}

Result<std::vector<Picture>> draw_bark(const BarkCoat& coat) {
  int height = std::max(1, static_cast<int>(std::lround(coat.pixels * coat.aspect)));
  Seed seed = bark_seed();
  BarkMaps maps = bark_maps(coat.image, coat.pixels, height, seed);
  Result<std::string> color = png_text(bark_colors(coat.image, maps, seed));
  Result<std::string> relief = png_text(grey_picture(maps.height));
  if (!color) return color.errors();
  if (!relief) return relief.errors();
  return std::vector<Picture>{{bark_color_name(coat), std::move(*color)},
                              {bark_height_name(coat), std::move(*relief)}};
}

}  // namespace

Errors load_bark_photo(const NamedFile& file, BarkCoat& coat) {
  auto tile = photograph<Raster>(file, read_bark_photo, [](const Raster& r) { return r.data.size(); });
  if (!tile) return tile.errors();
  coat.aspect = static_cast<double>((*tile)->height) / (*tile)->width;
  coat.wrap = coat.tall / coat.aspect;
  if (coat.aspect < 0.25 || coat.aspect > 16)
    return {Error{"", fmt::format("is {} x {} pixels; expected a picture 0.25 to 16 times as tall as wide",
                                  (*tile)->width, (*tile)->height)}};
  coat.image.photo = std::move(*tile);
  return {};
}

std::string bark_color_name(const BarkCoat& coat) { return name_of(coat, "color"); }
std::string bark_height_name(const BarkCoat& coat) { return name_of(coat, "height"); }

Drawing bark_drawing(const BarkCoat& coat) {
  constexpr double kSecondsAPixel = 2e-6;  // of both
  double pixels = coat.aspect * coat.pixels * coat.pixels;
  return {{bark_color_name(coat), bark_height_name(coat)},
          [coat] { return draw_bark(coat); },
          2 * pixels,
          kSecondsAPixel * pixels};
}

}  // namespace frond
