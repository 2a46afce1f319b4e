#include "images/bark_photo.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/parallel.h"
#include "images/photo.h"

namespace frond {

namespace {

constexpr double kEdge = 0.25;   // share of the picture over which an edge fades
constexpr double kBlur = 0.125;  // half the width over which brightness is evened out, as a share
constexpr double kLowest = 0.02,
                 kHighest = 0.98;  // share of pixels that is darker than the deepest, the highest

using Light = PixelGrid<Vec3>;  // linear

Light light_of(const Raster& picture) {
  Light light(picture.width, picture.height);
  for (std::size_t i = 0; i < light.data.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      std::size_t channels = static_cast<std::size_t>(picture.channels);
      light.data[i][static_cast<int>(c)] = linear(picture.data[channels * i + (channels == 1 ? 0 : c)]);
    }
  return light;
}

Raster raster_of(const Light& light) {
  Raster picture(light.width, light.height, 3);
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = to_byte(encoded(std::clamp<double>(light.data[i / 3][static_cast<int>(i % 3)], 0, 1)));
  return picture;
}

float brightness(Vec3 light) { return 0.2126f * light.x + 0.7152f * light.y + 0.0722f * light.z; }

DVec3 mean_of(const Light& light) {
  DVec3 sum(0);
  for (Vec3 v : light.data) sum += v;
  return sum / static_cast<double>(light.data.size());
}

/// The mean of the brightness over `reach` pixels either way along the rows, in all channels; what is beyond
/// the edges counts as the edge.
Light blurred(const Light& light, int reach) {
  Light made(light.width, light.height);
  parallel_for(static_cast<std::size_t>(light.height), [&](std::size_t row) {
    int y = static_cast<int>(row);
    auto at = [&](int x) {
      return static_cast<double>(brightness(light.at(std::clamp(x, 0, light.width - 1), y)));
    };
    double sum = 0;
    for (int x = -reach; x <= reach; ++x) sum += at(x);
    for (int x = 0; x < light.width; ++x) {
      made.at(x, y) = Vec3(static_cast<float>(sum / (2 * reach + 1)));
      sum += at(x + reach + 1) - at(x - reach);
    }
  });
  return made;
}

/// Divides by what is left of its brightness after a wide blur: twice a box in both directions.
void flatten(Light& light) {
  Light wide = light;
  for (int pass = 0; pass < 4; ++pass)
    wide = transposed(blurred(wide, std::max(1, static_cast<int>(kBlur * wide.width))));
  float mean = brightness(Vec3(mean_of(wide)));
  for (std::size_t i = 0; i < light.data.size(); ++i) light.data[i] *= mean / std::max(wide.data[i].x, 1e-4f);
}

/// Lets the left and the right edge fade into what lies half a picture away, so that they meet. The mix keeps
/// the contrast of what is mixed (Heitz and Neyret 2018, without their change of the histogram).
Light joined(const Light& light) {
  Light made(light.width, light.height);
  Vec3 mean(mean_of(light));
  for (int x = 0; x < light.width; ++x) {
    double edge = (std::min(x, light.width - 1 - x) + 0.5) / light.width;
    auto own = static_cast<float>(smooth_step(0.0, kEdge, edge));
    float other = 1 - own, contrast = std::sqrt(own * own + other * other);
    int away = (x + light.width / 2) % light.width;
    for (int y = 0; y < light.height; ++y)
      made.at(x, y) = mean + (own * (light.at(x, y) - mean) + other * (light.at(away, y) - mean)) / contrast;
  }
  return made;
}

/// Rows in another width, each pixel the mean of those around it, round and round.
Light resized_rows(const Light& light, int width) {
  Light made(width, light.height);
  double step = static_cast<double>(light.width) / width, reach = std::max(step, 1.0);
  parallel_for(static_cast<std::size_t>(light.height), [&](std::size_t row) {
    int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      double middle = (x + 0.5) * step - 0.5;
      Vec3 sum(0);
      float total = 0;
      for (int i = static_cast<int>(std::ceil(middle - reach)); i <= middle + reach; ++i) {
        auto share = static_cast<float>(1 - std::abs(i - middle) / reach);
        sum += share * light.at((i % light.width + light.width) % light.width, y);
        total += share;
      }
      made.at(x, y) = sum / total;
    }
  });
  return made;
}

}  // namespace

Result<Raster> read_bark_photo(std::string_view bytes) {
  Result<Raster> read = read_photo(bytes);
  if (!read) return read;
  Light light = light_of(*read);
  DVec3 mean = mean_of(light);
  flatten(light);
  light = transposed(joined(transposed(joined(light))));
  for (Vec3& v : light.data) v = glm::clamp(v, Vec3(0), Vec3(1));
  Vec3 factor = Vec3(mean / glm::max(mean_of(light), DVec3(1e-4)));
  for (Vec3& v : light.data) v *= factor;
  return raster_of(light);
}

Raster tinted_tile(const Raster& tile, Color mean) {
  Light light = light_of(tile);
  Vec3 factor = linear(mean) / glm::max(Vec3(mean_of(light)), Vec3(1e-4f));
  for (Vec3& v : light.data) v *= factor;
  return raster_of(light);
}

Raster resized_tile(const Raster& tile, int width, int height) {
  if (tile.width == width && tile.height == height) return tile;
  return raster_of(transposed(resized_rows(transposed(resized_rows(light_of(tile), width)), height)));
}

Grid tile_heights(const Raster& tile) {
  Grid heights(tile.width, tile.height);
  Light light = light_of(tile);
  for (std::size_t i = 0; i < heights.data.size(); ++i)
    heights.data[i] = static_cast<float>(encoded(static_cast<double>(brightness(light.data[i]))));
  std::vector<float> sorted = heights.data;
  std::ranges::sort(sorted);
  auto at = [&](double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  float low = at(kLowest), high = std::max(at(kHighest), low + 0.01f);
  for (float& h : heights.data) h = std::clamp((h - low) / (high - low), 0.0f, 1.0f);
  return heights;
}

}  // namespace frond
