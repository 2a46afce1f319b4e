#include "studio/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "core/bytes.h"
#include "core/content.h"
#include "core/linear.h"
#include "emit/setting.h"
#include "export/materials.h"

namespace frond {

namespace {

constexpr int kPixels = 256;
constexpr int kSkinPixels = 512;  // as exports have them, which keep them where we look for them
constexpr int kFloorPixels = 512;
constexpr int kSkyPixels = 1024;
constexpr float kDarkest = 0.01f;
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
  m.dead.clear();
  return m;
}

/// A piece of a setting's floor, as seen from above.
std::optional<Swatch> floor_swatch(const SceneSetup& setup) {
  constexpr double kWide = 3;  // metres: ripples show, and the same comes again seldom
  std::optional<FloorTexture> floor = floor_texture(setup);
  if (!floor) return std::nullopt;
  Swatch swatch;
  swatch.includes = floor->includes;
  swatch.texture = fmt::format("texture{{{} rotate -90*x}}", floor->inside);
  swatch.pixels = {kFloorPixels, kFloorPixels};
  swatch.wide = kWide;
  return swatch;
}

Tile named(const std::string& made_from) {
  std::string id = content_id(made_from);
  return {"tile_" + id + "_color.png", "tile_" + id + "_normal.png"};
}

/// Draws what a tile names.
template <class Draw>
Drawing drawing_of(const Tile& tile, Draw draw) {
  std::vector<std::string> names{tile.colors};
  if (!tile.normals.empty()) names.push_back(tile.normals);
  return {names, [names, draw]() -> Result<std::vector<Picture>> {
            Result<BakedPictures> baked = draw();
            if (!baked) return baked.errors();
            std::vector<Picture> made{{names[0], std::move(baked->colors)}};
            if (names.size() > 1) made.push_back({names[1], std::move(baked->normals)});
            return made;
          }};
}

}  // namespace

std::optional<Tile> tile_of(const Material& material) {
  const MatterRow& row = row_of(material.matter);
  if (row.widths <= 0 || !material.picture.empty() || row.nature == Nature::vessel) return std::nullopt;
  Material drawn = shared(material);
  Tile tile = named(swatch_scene(body_swatch(drawn, kPixels)));
  tile.wide = tile.high = row.widths * material.scale;
  tile.light = linear(material.color) / linear(drawn.color);
  return tile;
}

std::optional<Tile> tile_of(const Solid& body) {
  if (!is_vessel(body)) return tile_of(body.material);
  if (row_of(body.material.matter).widths <= 0) return std::nullopt;
  auto bytes = [](const auto& list) {
    return std::string_view(reinterpret_cast<const char*>(list.data()), bytes_of(list));
  };
  Tile tile = named(fmt::format("{}{}{}", swatch_scene(body_swatch(body.material, kPixels)),
                                bytes(body.surface.position), bytes(body.surface.uv)));
  tile.normals.clear();
  tile.unrolled = true;
  return tile;
}

std::optional<Tile> tile_of(const BranchLook& branches, std::size_t color) {
  const BarkCoat* worn = branches.coat_of(color);
  if (!worn && !branches.patterned(color)) return std::nullopt;
  Tile tile;
  if (worn) {
    const BarkCoat& coat = *worn;
    tile = named(fmt::format("{} {}", bark_color_name(coat), coat.relief));
    tile.wide = coat.wrap, tile.high = coat.wrap * coat.aspect;
  } else {
    tile = named(swatch_scene(skin_swatch(branches, color, kSkinPixels)));
    std::tie(tile.wide, tile.high) = Palette::picture_size(branches, color);
  }
  tile.varied = true;
  tile.light = 1.0f / glm::max(linear(branches.plain(color, 1)), Vec3(kDarkest));
  return tile;
}

std::optional<Tile> tile_of(const SceneSetup& setup) {
  std::optional<Swatch> swatch = floor_swatch(setup);
  if (!swatch) return std::nullopt;
  Tile tile = named(swatch_scene(*swatch));
  tile.wide = tile.high = swatch->wide;
  return tile;
}

std::optional<Drawing> sky_drawing(const Scene& scene, const BakeOptions& options) {
  std::optional<std::string> text = sky_scene_text({}, scene);
  if (!text) return std::nullopt;
  std::string name = "sky_" + content_id(*text) + ".png";
  SmallScene sky{std::move(*text), {kSkyPixels, kSkyPixels / 2}, false, kSkyPixels / 4, {}};
  return Drawing{{name}, [name, sky = std::move(sky), options]() -> Result<std::vector<Picture>> {
                   Result<std::string> made = small_picture(sky, options);
                   if (!made) return made.errors();
                   return std::vector<Picture>{{name, std::move(*made)}};
                 }};
}

Drawing tile_drawing(const SceneSetup& setup, const BakeOptions& options) {
  return drawing_of(*tile_of(setup),
                    [swatch = *floor_swatch(setup), options] { return bake(swatch, kRough, options); });
}

Drawing tile_drawing(const Material& material, const BakeOptions& options) {
  return drawing_of(*tile_of(material), [drawn = shared(material), options] {
    return bake(body_swatch(drawn, kPixels), kRough, options);
  });
}

Drawing tile_drawing(const Solid& body, const BakeOptions& options) {
  if (!is_vessel(body)) return tile_drawing(body.material, options);
  return drawing_of(*tile_of(body), [swatch = vessel_swatch(body, body.material, kPixels), options] {
    return bake(swatch, kRough, options);
  });
}

Drawing tile_drawing(const BranchLook& branches, const BakeOptions& options, std::size_t color) {
  return drawing_of(*tile_of(branches, color), [branches, color, options] {
    const BarkCoat* coat = branches.coat_of(color);
    return coat ? coat_pictures(*coat, std::min(kSkinPixels, coat->pixels))
                : bake(skin_swatch(branches, color, kSkinPixels), skin_roughness(branches), options);
  });
}

Json json_of(const Tile& tile) {
  Json json{
      {"colors", tile.colors}, {"wide", tile.wide}, {"high", tile.high}, {"light", json_of(tile.light)}};
  if (!tile.normals.empty()) json["normals"] = tile.normals;
  if (tile.varied) json["varied"] = true;
  if (tile.unrolled) json["unrolled"] = true;
  return json;
}

}  // namespace frond
