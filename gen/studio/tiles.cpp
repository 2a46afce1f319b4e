#include "studio/tiles.h"

#include <algorithm>
#include <cmath>

#include "core/content.h"
#include "core/linear.h"

namespace frond {

namespace {

constexpr int kPixels = 256;
constexpr double kRough = 0.8;  // the page shows no roughness

double stepped(double x, double step) { return step * std::round(x / step); }

/// The material that stands for all that are much like it.
Material shared(const Material& own) {
  constexpr double kScaleStep = 0.22;  // of its logarithm
  constexpr float kColorStep = 0.125f, kBrightest = 0.5f;
  Material m = own;
  Vec3 light = linear(own.color), second = linear(own.second);
  float most = std::max({light.x, light.y, light.z, 1e-3f});
  auto coarse = [&](Vec3 c) {
    return srgb(kBrightest *
                glm::clamp(kColorStep * glm::round(c / (most * kColorStep)), 0.5f * kColorStep, 2.0f));
  };
  m.color = coarse(light), m.second = coarse(second);
  m.scale = std::exp(stepped(std::log(own.scale), kScaleStep));
  m.relief = stepped(own.relief, 0.25), m.moss = stepped(own.moss, 0.25), m.gloss = stepped(own.gloss, 0.25);
  m.bands.clear();
  m.polyps = {};
  return m;
}

}  // namespace

std::optional<Tile> tile_of(const Material& material) {
  const MatterRow& row = row_of(material.matter);
  if (row.widths <= 0 || !material.picture.empty() || row.nature == Nature::vessel) return std::nullopt;
  Material drawn = shared(material);
  std::string id = content_id(swatch_scene(body_swatch(drawn, kPixels)));
  return Tile{"tile_" + id + "_color.png", "tile_" + id + "_normal.png", row.widths * material.scale,
              linear(material.color) / linear(drawn.color)};
}

Drawing tile_drawing(const Material& material, const BakeOptions& options) {
  Tile tile = *tile_of(material);
  return {{tile.colors, tile.normals}, [=]() -> Result<std::vector<Picture>> {
            Result<BakedPictures> baked = bake(body_swatch(shared(material), kPixels), kRough, options);
            if (!baked) return baked.errors();
            return std::vector<Picture>{{tile.colors, std::move(baked->colors)},
                                        {tile.normals, std::move(baked->normals)}};
          }};
}

}  // namespace frond
