#include "export/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/linear.h"
#include "core/parallel.h"
#include "export/look.h"

namespace frond {

namespace {

constexpr float kFaceOfGlass = 0.36f;
constexpr int kLeafPixels = 256;  // the most of a leaf without a picture of its own

std::string key_of(const Color& c) { return fmt::format("{:.4f},{:.4f},{:.4f};", c.red, c.green, c.blue); }

std::string key_of(const Bark& b, std::size_t color) {
  return fmt::format("bark {} {} {} {}{}", static_cast<int>(b.kind), b.scale, b.depth,
                     key_of(b.colors[color]), key_of(b.second));
}

std::string key_of(const Skin& s) {
  const Tint& t = s.tint;
  return fmt::format("skin {} {} {} {} {} {} {} {}{}", static_cast<int>(s.kind), s.pores.cell, s.pores.warp,
                     s.pores.depth, t.hue, t.saturation, t.value, key_of(t.base), key_of(t.secondary));
}

std::string key_of(const Material& m) {
  std::string key = fmt::format("matter {} {} {} {} {} {}{}", static_cast<int>(m.matter), m.scale, m.relief,
                                m.moss, m.gloss, key_of(m.color), key_of(m.second));
  for (const Band& b : m.bands)
    key +=
        fmt::format("{} {} {} {} {}", b.at, b.width, static_cast<int>(b.motif), b.repeats, key_of(b.color));
  return key;
}

std::string key_of(Vec3 v) { return fmt::format("{:.4f},{:.4f},{:.4f};", v.x, v.y, v.z); }

Color lighter(const Color& color, Vec3 factor) {
  Vec3 light = glm::min(linear(color) * factor, Vec3(1));
  return {static_cast<float>(encoded(light.x)), static_cast<float>(encoded(light.y)),
          static_cast<float>(encoded(light.z))};
}

/// Pictures whose colours give back so much more light.
Pictures lighter(Pictures pictures, Vec3 factor) {
  Raster& colors = pictures.colors;
  for (std::size_t c = 0; c < 3; ++c) {
    auto more = static_cast<double>(factor[static_cast<int>(c)]);
    if (more == 1) continue;
    std::array<std::uint8_t, 256> of{};
    for (std::size_t x = 0; x < 256; ++x)
      of[x] = to_byte(encoded(std::min(1.0, more * linear(static_cast<double>(x) / 255))));
    auto step = static_cast<std::size_t>(colors.channels);
    for (std::size_t i = c; i < colors.data.size(); i += step) colors.data[i] = of[colors.data[i]];
  }
  return pictures;
}

/// A bark drawn by a pattern in space, as the picture that comes nearest to it.
BarkImage image_of(const Bark& bark, std::size_t color) {
  BarkImage image;
  image.pattern = bark.kind == BarkKind::birch ? BarkPattern::banded : BarkPattern::furrowed;
  image.color = bark.colors[color];
  image.second = bark.second;
  image.lichens = 0.1;
  if (bark.kind == BarkKind::birch) image.stretch = 2.5;
  return image;
}

Pictures bark_pictures(const BarkImage& image, double depth, int width, int height) {
  Seed seed{11};
  BarkMaps maps = bark_maps(image, width, height, seed);
  return {bark_colors(image, maps, seed), normal_picture(maps.height, 0.02 * width * depth),
          roughness_of(maps.height, 0.8)};
}

/// A leaf's picture: where it is open it has the colour of the rim, or its edge would be seen dark.
Pictures leaf_pictures(const LeafLook& look, std::size_t color, int pixels) {
  LeafImage image = leaf_image(look, color);
  // In all seasons the same spots.
  Raster colors = leaf_picture(image, pixels, Seed{color < look.colors.size() ? color : 0});
  Grid height(colors.width, colors.height);
  Pictures made{std::move(colors), {}, {}};
  std::uint8_t rim[] = {to_byte(image.rim.red), to_byte(image.rim.green), to_byte(image.rim.blue)};
  for (std::size_t i = 0; i < height.data.size(); ++i) {
    std::uint8_t* pixel = &made.colors.data[4 * i];
    if (pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0) std::copy_n(rim, 3, pixel);
    // Veins are paler than what lies between, and sunk in.
    double bright = (0.3 * pixel[0] + 0.6 * pixel[1] + 0.1 * pixel[2]) / 255;
    height.data[i] = static_cast<float>(1 - bright);
  }
  made.normals = normal_picture(height, 0.012 * pixels);
  made.roughness = roughness_of(height, 0.6);
  return made;
}

bool patterned(Matter matter) {
  return matter != Matter::plain && matter != Matter::pane && matter != Matter::glass;
}

}  // namespace

std::string Names::unique(const std::string& name) {
  int times = times_[name]++;
  return times == 0 ? name : unique(fmt::format("{}_{}", name, times + 1));
}

void Palette::add_pictures(ExportMaterial& material, const std::string& key, const std::string& name,
                           const std::function<Pictures()>& draw) {
  auto [at, fresh] = drawn_.try_emplace(key, std::array{kNoPicture, kNoPicture, kNoPicture});
  if (fresh) {
    Pictures made = draw();
    const Raster* rasters[] = {&made.colors, &made.normals, &made.roughness};
    const char* words[] = {"_color", "_normal", "_roughness"};
    std::array<Result<std::string>, 3> bytes{std::string(), std::string(), std::string()};
    parallel_for(3, [&](std::size_t i) { bytes[i] = png_text(*rasters[i]); });
    for (std::size_t i = 0; i < 3; ++i) {
      if (!bytes[i]) continue;
      at->second[i] = scene_.pictures.size();
      scene_.pictures.push_back({name + words[i], std::move(*bytes[i])});
    }
  }
  material.colors = at->second[0], material.normals = at->second[1], material.roughness = at->second[2];
}

void Palette::add_drawn(ExportMaterial& material, const Look& look, const std::string& picture) {
  auto [at, fresh] = drawn_.try_emplace(picture, std::array{kNoPicture, kNoPicture, kNoPicture});
  for (const Drawing& drawing : fresh ? drawings(look) : std::vector<Drawing>()) {
    auto which = std::ranges::find(drawing.names, picture);
    if (which == drawing.names.end()) continue;
    auto made = drawing.draw();
    if (!made) continue;
    at->second[0] = scene_.pictures.size();
    std::string& bytes = (*made)[static_cast<std::size_t>(which - drawing.names.begin())].bytes;
    scene_.pictures.push_back({material.name + "_color", std::move(bytes)});
  }
  material.colors = at->second[0];
}

template <class Draw>
Palette::Use Palette::keep(const std::string& key, ExportMaterial made, const std::string& name,
                           const Draw& draw) {
  auto [at, fresh] = used_.try_emplace(key + key_of(made.factor) + key_of(made.color));
  if (!fresh) return at->second;
  Use use;
  made.name = names_.unique(name);
  if (options_.texture > 0) draw(made, use);
  use.material = scene_.materials.size();
  scene_.materials.push_back(std::move(made));
  return at->second = use;
}

Palette::Use Palette::branches(const Look& look, double brightness, std::size_t color,
                               const std::string& name, bool ages) {
  int pixels = options_.texture;
  Vec3 young = ages ? look.branches.young_light(color) : Vec3(1), most = glm::max(young, Vec3(1));
  auto aged = [&](Use use) { return use.young = young, use; };
  ExportMaterial made;
  made.factor = scaled({1, 1, 1}, brightness);
  if (look.branches.coat) {
    const BarkCoat& coat = *look.branches.coat;
    made.color = scaled(coat.image.color, 0.85 * brightness);
    return keep("coat " + bark_color_name(coat), made, name, [&](ExportMaterial& m, Use&) {
      int wide = std::min(pixels, coat.pixels),
          high = std::max(1, static_cast<int>(std::lround(wide * coat.aspect)));
      add_pictures(m, bark_color_name(coat), m.name,
                   [&] { return bark_pictures(coat.image, coat.relief, wide, high); });
    });
  }
  if (look.branches.skin) {
    made.color = lighter(tinted(look.branches.skin->tint, brightness), most), made.gloss = 0.1;
    std::string key = key_of(*look.branches.skin) + key_of(most);
    return aged(keep(key, made, name, [&](ExportMaterial& m, Use& use) {
      add_pictures(m, key, m.name,
                   [&] { return lighter(pictures_of(skin_tile(*look.branches.skin, pixels), 0.75), most); });
      std::tie(use.wide, use.high) = picture_size(look);
    }));
  }
  const Bark& bark = *look.branches.bark;
  made.color = lighter(scaled(bark.colors[color], brightness), most);
  made.gloss = look.branches.gloss(), made.metal = look.branches.metal();
  std::string key = key_of(bark, color) + key_of(most);
  return aged(keep(key, made, name, [&](ExportMaterial& m, Use& use) {
    if (bark.kind == BarkKind::palm) {
      add_pictures(m, key, m.name, [&] { return lighter(pictures_of(palm_tile(bark, pixels), 0.85), most); });
    } else if (bark.kind == BarkKind::bark || bark.kind == BarkKind::birch) {
      BarkImage image = image_of(bark, color);
      add_pictures(m, key, m.name,
                   [&] { return lighter(bark_pictures(image, 1.5 * bark.depth, pixels, 2 * pixels), most); });
    } else {
      m.factor = m.color;
    }
    std::tie(use.wide, use.high) = picture_size(look);
  }));
}

std::pair<double, double> Palette::picture_size(const Look& look) {
  constexpr double kRidge = 1.2;  // a ridge and the furrow beside it, in widths of a furrow
  if (look.branches.coat) return {1, 1};
  if (look.branches.skin) return {skin_metres(*look.branches.skin), skin_metres(*look.branches.skin)};
  if (look.branches.bark->kind == BarkKind::palm)
    return {palm_metres(*look.branches.bark), palm_metres(*look.branches.bark)};
  double wide = kRidge * BarkImage{}.ridges * look.branches.bark->scale;
  return {wide, 2 * wide};
}

Palette::Use Palette::cubes(const Look& look, double brightness, std::size_t color, const std::string& name) {
  Vec3 young = options_.tints ? look.branches.young_light(color) : Vec3(1);
  ExportMaterial made;
  made.color = look.branches.skin ? tinted(look.branches.skin->tint, brightness)
                                  : scaled(look.branches.bark->colors[color], brightness);
  made.color = lighter(made.color, glm::max(young, Vec3(1)));
  made.gloss = 0.2;
  Use use = keep("cube", made, name, [&](ExportMaterial& m, Use&) {
    add_pictures(m, "cube " + key_of(m.color), m.name,
                 [&] { return pictures_of(cube_tile(m.color, std::min(options_.texture, 128)), 0.75); });
  });
  use.young = young;
  return use;
}

std::size_t Palette::organ(const Look& look, const Prototype& organ, std::size_t part, std::size_t color,
                           Lies lies, const std::string& name) {
  bool card = lies == Lies::card, laid = lies != Lies::nowhere;
  Tissue tissue = organ.parts[part].tissue;
  ExportMaterial made;
  made.color = tissue == Tissue::heart ? organ.second : organ.colors[color];
  made.gloss = tissue == Tissue::fruit ? 0.6 : 0.2, made.leaf = is_leaf(tissue), made.cutout = card;
  if (laid && look.leaves && color < organ.parts[part].pictures.size()) {
    const std::string& key = organ.parts[part].pictures[color];
    int pixels = std::min(options_.texture, 2 * look.leaves->pixels);
    return keep((card ? "card " : "") + key, made, name,
                [&](ExportMaterial& m, Use&) {
                  add_pictures(m, key, m.name, [&] { return leaf_pictures(*look.leaves, color, pixels); });
                })
        .material;
  }
  if (const auto& shown = organ.parts[part].pictures; laid && color < shown.size())
    return keep(shown[color], made, name, [&](ExportMaterial& m, Use&) { add_drawn(m, look, shown[color]); })
        .material;
  if (tissue == Tissue::dew) made.color = {1, 1, 1}, made.gloss = 1.2, made.transmission = 0.95;
  std::string key = fmt::format("organ {} {} {}", static_cast<int>(tissue), laid, key_of(organ.second));
  return keep(key, made, name,
              [&](ExportMaterial& m, Use&) {
                if (!made.leaf || !laid) return void(m.factor = m.color);
                add_pictures(m, key + key_of(m.color), m.name, [&] {
                  int pixels = std::min(options_.texture, kLeafPixels);
                  return pictures_of(tissue_tile(tissue, m.color, organ.second, pixels), 0.6);
                });
              })
      .material;
}

std::size_t Palette::blade(const BladeLook& look, std::size_t color, const std::string& name) {
  Prototype blade{"blade", {{look.tissue, {}}}, look.colors, look.second};
  return organ({}, blade, 0, color, Lies::mesh, name);
}

Palette::Use Palette::body(const Look& look, const Material& material, bool vessel, const std::string& name) {
  ExportMaterial made;
  made.color = material.color, made.gloss = material.gloss;
  if (material.matter == Matter::glass) {
    // Light takes on the colour at each of the four faces of two walls: each gives a share of it.
    Vec3 face = glm::pow(linear(material.color), Vec3(kFaceOfGlass));
    made.color = {static_cast<float>(encoded(face.x)), static_cast<float>(encoded(face.y)),
                  static_cast<float>(encoded(face.z))};
    made.transmission = 0.95, made.gloss = 1.2;
  }
  if (material.matter == Matter::pane) made.gloss = 1.1;
  if (material.matter == Matter::ceramic) made.gloss = 0.4 + 0.8 * material.gloss;
  if (!material.picture.empty())
    return keep(material.picture, made, name,
                [&](ExportMaterial& m, Use&) { add_drawn(m, look, material.picture); });
  std::string key = key_of(material);
  return keep((vessel ? "vessel " : "") + key, made, name, [&](ExportMaterial& m, Use& use) {
    bool painted = vessel && (patterned(material.matter) || !material.bands.empty());
    if (!painted && !patterned(material.matter)) return void(m.factor = m.color);
    Tile tile =
        painted ? vessel_tile(material, 2 * options_.texture) : matter_tile(material, options_.texture);
    use.wide = use.high = tile.metres;
    m.color = mean_color(tile);
    add_pictures(m, (vessel ? "vessel " : "") + key, m.name,
                 [&] { return pictures_of(tile, std::clamp(0.95 - 0.75 * m.gloss, 0.05, 1.0)); });
  });
}

}  // namespace frond
