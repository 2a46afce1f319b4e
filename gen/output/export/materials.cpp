#include "export/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/linear.h"
#include "core/parallel.h"
#include "emit/branch_materials.h"
#include "emit/plant.h"
#include "images/bark.h"
#include "images/leaf_relief.h"

namespace frond {

namespace {

constexpr float kFaceOfGlass = 0.36f;
constexpr int kLeafPixels = 256;    // the most of a leaf without a picture of its own
constexpr float kVeinDepth = 0.1f;  // of what raises a photograph from black to white
constexpr int kCubePixels = 128;
constexpr int kRings = 4;        // of a palm, on its picture
constexpr double kPatterns = 8;  // how many times what a skin's pattern repeats, on its picture

std::string key_of(const Color& c) { return fmt::format("{:.4f},{:.4f},{:.4f};", c.red, c.green, c.blue); }

Color lighter(const Color& color, Vec3 factor) { return srgb(glm::min(linear(color) * factor, Vec3(1))); }

/// A leaf's picture: where it is open it has the colour of the rim, or its edge would be seen dark.
Result<BakedPictures> leaf_pictures(const LeafLook& look, std::size_t color, int pixels) {
  LeafImage image = leaf_image(look, color);
  // In all seasons the same spots.
  Seed seed{color < look.colors.size() ? color : 0};
  Raster colors = leaf_picture(image, pixels, seed);
  Grid height = image.photo ? Grid(colors.width, colors.height) : leaf_heights(image, pixels, seed);
  std::uint8_t rim[] = {to_byte(image.rim.red), to_byte(image.rim.green), to_byte(image.rim.blue)};
  for (std::size_t i = 0; i < height.data.size(); ++i) {
    std::uint8_t* pixel = &colors.data[4 * i];
    if (pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0) std::copy_n(rim, 3, pixel);
    // Veins of a photograph are paler than what lies between, and sunk in.
    height.data[i] = image.photo
                         ? static_cast<float>(1 - (0.3 * pixel[0] + 0.6 * pixel[1] + 0.1 * pixel[2]) / 255)
                         : kVeinDepth * height.data[i];
  }
  return picture_files(colors, normal_picture(height, 0.012 * pixels), 0.6);
}

/// The picture of that name, of those that the look wears.
Result<BakedPictures> worn(const Look& look, const std::string& picture) {
  for (const Drawing& drawing : drawings(look)) {
    auto which = std::ranges::find(drawing.names, picture);
    if (which == drawing.names.end()) continue;
    auto made = drawing.draw();
    if (!made) return made.errors();
    BakedPictures files;
    files.colors = std::move((*made)[static_cast<std::size_t>(which - drawing.names.begin())].bytes);
    return files;
  }
  return Error{"", "no look wears " + picture};
}

}  // namespace

std::vector<Vec2> on_vessel(std::vector<Vec2> uv) {
  constexpr float kOutside = 0.75f;
  for (Vec2& at : uv) at.y = at.y < 1 ? kOutside * at.y : kOutside + (1 - kOutside) * (at.y - 1);
  return uv;
}

bool is_vessel(const Solid& solid) {
  return !solid.surface.uv.empty() && row_of(solid.material.matter).nature == Nature::vessel;
}

Swatch vessel_swatch(const Solid& vessel, const Material& material, int pixels) {
  Swatch swatch = body_swatch(material, pixels);
  swatch.pixels = {2 * pixels, 3 * pixels / 2};
  swatch.body = vessel.surface;
  swatch.place = on_vessel(vessel.surface.uv);
  return swatch;
}

Swatch skin_swatch(const BranchLook& look, std::size_t color, int pixels) {
  Swatch swatch;
  swatch.includes = {include_of(look)};
  if (look.polyps()) swatch.includes.emplace_back("reef");
  swatch.before =
      fmt::format("#declare Skin=array[{0}];\n#declare Skin_Pigment=array[{0}][2];\n", look.colors());
  append_skin_declarations(swatch.before, look, 1, 0, false, "");
  swatch.texture = skin_texture(color);
  auto [wide, high] = Palette::picture_size(look, color);
  swatch.wide = wide;
  swatch.corner.z = static_cast<float>(0.137 * wide);  // off the planes where noise is even
  swatch.pixels = {pixels, static_cast<int>(std::lround(pixels * high / wide))};
  return swatch;
}

double skin_roughness(const BranchLook& look) { return look.coral() ? 0.75 : 0.85; }

Result<BakedPictures> coat_pictures(const BarkCoat& coat, int wide) {
  int high = std::max(1, static_cast<int>(std::lround(wide * coat.aspect)));
  Seed seed{11};
  BarkMaps maps = bark_maps(coat.image, wide, high, seed);
  return picture_files(bark_colors(coat.image, maps, seed),
                       normal_picture(maps.height, 0.02 * wide * coat.relief), 0.8);
}

std::string Names::unique(const std::string& name) {
  int times = times_[name]++;
  return times == 0 ? name : unique(fmt::format("{}_{}", name, times + 1));
}

Palette::Use Palette::keep(const std::string& key, ExportMaterial made, const std::string& name,
                           const std::string& picture, const PictureMaker& make, double wide, double high) {
  auto [at, fresh] = used_.try_emplace(key + key_of(made.factor) + key_of(made.color));
  if (!fresh) return at->second;
  made.name = names_.unique(name);
  if (make && options_.texture > 0) {
    auto [which, first] = drawn_by_.try_emplace(picture, pending_.size());
    if (first) pending_.push_back({made.name, make, {}});
    pending_[which->second].materials.push_back(scene_.materials.size());
  }
  at->second = {scene_.materials.size(), wide, high};
  scene_.materials.push_back(std::move(made));
  return at->second;
}

Palette::Use Palette::keep_swatch(Swatch swatch, ExportMaterial made, const std::string& name, double rough) {
  if (options_.texture == 0) return keep(swatch.before + swatch.texture, std::move(made), name, {}, {});
  for (int& pixels : swatch.pixels) pixels += pixels % 2;  // normals have half as many
  double wide = swatch.wide, high = wide * swatch.pixels[1] / swatch.pixels[0];
  std::string key = fmt::format("{} {} {} {}\n", swatch.light.x, swatch.light.y, swatch.light.z, rough) +
                    swatch_scene(swatch);
  auto make = [swatch = std::move(swatch), rough, &options = options_] {
    return bake(swatch, rough, options.bake);
  };
  return keep(key, std::move(made), name, key, make, wide, high);
}

std::size_t Palette::add_picture(std::string name, std::string bytes) {
  if (bytes.empty()) return kNoPicture;
  scene_.pictures.push_back({std::move(name), std::move(bytes)});
  return scene_.pictures.size() - 1;
}

std::size_t Palette::shown(ExportMaterial made, const std::string& name, BakedPictures pictures) {
  made.name = names_.unique(name);
  if (pictures.mean) made.color = *pictures.mean;
  made.colors = add_picture(made.name + "_color", std::move(pictures.colors));
  made.normals = add_picture(made.name + "_normal", std::move(pictures.normals));
  scene_.materials.push_back(std::move(made));
  return scene_.materials.size() - 1;
}

Errors Palette::make_pictures() {
  std::vector<Result<BakedPictures>> made(pending_.size(), BakedPictures{});
  parallel_for(pending_.size(), [&](std::size_t i) { made[i] = pending_[i].make(); });
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (!made[i]) return made[i].errors();
    const std::string& name = pending_[i].name;
    std::size_t colors = add_picture(name + "_color", std::move(made[i]->colors)),
                normals = add_picture(name + "_normal", std::move(made[i]->normals)),
                roughness = add_picture(name + "_roughness", std::move(made[i]->roughness));
    for (std::size_t of : pending_[i].materials) {
      ExportMaterial& material = scene_.materials[of];
      if (made[i]->mean) material.color = srgb(linear(*made[i]->mean) * linear(material.factor));
      material.colors = colors, material.normals = normals, material.roughness = roughness;
    }
  }
  return {};
}

Palette::Use Palette::branches(const Look& look, double brightness, std::size_t color,
                               const std::string& name, bool ages) {
  int pixels = options_.texture;
  Vec3 young = ages ? look.branches.young_light(color, Built::branches) : Vec3(1),
       most = glm::max(young, Vec3(1));
  ExportMaterial made;
  made.factor = scaled({1, 1, 1}, brightness);
  if (const BarkCoat* worn = look.branches.coat_of(color)) {
    const BarkCoat& coat = *worn;
    made.color = scaled(coat.image.color, 0.85 * brightness);
    std::string picture = bark_color_name(coat);
    return keep("coat " + picture, made, name, picture,
                [coat, wide = std::min(pixels, coat.pixels)] { return coat_pictures(coat, wide); });
  }
  made.color = lighter(look.branches.plain(color, brightness), most);
  made.gloss = look.branches.gloss(color), made.metal = look.branches.metal(color);
  Use use;
  if (look.branches.patterned(color)) {
    Swatch swatch = skin_swatch(look.branches, color, pixels);
    swatch.light = most;
    use = keep_swatch(std::move(swatch), made, name, skin_roughness(look.branches));
  } else {
    made.factor = made.color;
    use = keep("plain" + key_of(made.factor), made, name, {}, {});
    std::tie(use.wide, use.high) = picture_size(look.branches, color);
  }
  use.young = young;
  return use;
}

std::pair<double, double> Palette::picture_size(const BranchLook& look, std::size_t color) {
  constexpr double kRidge = 1.2;  // a ridge and the furrow beside it, in widths of a furrow
  if (look.coat_of(color)) return {1, 1};
  if (look.coral()) return {kPatterns * look.pattern_size(), kPatterns * look.pattern_size()};
  if (look.ringed(color)) return {kRings * look.bark_scale(), kRings * look.bark_scale()};
  double wide = kRidge * BarkImage{}.ridges * look.bark_scale();
  return {wide, 2 * wide};
}

Palette::Use Palette::cubes(const BranchLook& look, double brightness, std::size_t color, double side,
                            const std::string& name) {
  Vec3 young = options_.tints ? look.young_light(color, Built::cubes) : Vec3(1),
       most = glm::max(young, Vec3(1));
  ExportMaterial made;
  made.color = lighter(look.plain(color, brightness), most);
  made.gloss = 0.2;
  Swatch swatch;
  swatch.includes = {"voxel"};
  swatch.texture = cube_texture(look, color, brightness, side, 0, kCubeShades - 1);
  int pixels = std::min(options_.texture, kCubePixels);
  swatch.pixels = {pixels, pixels};
  swatch.wide = side;
  swatch.corner = static_cast<float>(side) * Vec3(-0.5f, -0.5f, 0.5f);  // a face
  swatch.light = most;
  swatch.repeats = false;
  Use use = keep_swatch(std::move(swatch), made, name, 0.75);
  use.young = young;
  return use;
}

std::size_t Palette::organ(const Look& look, const Prototype& organ, std::size_t part, std::size_t color,
                           Lies lies, const std::string& name) {
  bool card = lies == Lies::card, laid = lies != Lies::nowhere;
  Tissue tissue = organ.parts[part].tissue;
  ExportMaterial made;
  made.color = tissue == Tissue::heart ? organ.second : organ.colors[color];
  made.gloss = tissue == Tissue::fruit ? 0.6 : 0.2, made.leaf = is_leaf(tissue);
  made.cutout = card && options_.texture > 0;
  if (const auto& shown = organ.parts[part].pictures; laid && color < shown.size()) {
    if (!look.leaves || tissue != Tissue::leaf)
      return keep(shown[color], made, name, shown[color],
                  [=, picture = shown[color]] { return worn(look, picture); })
          .material;
    int pixels = std::min(options_.texture, 2 * look.leaves->pixels);
    return keep((card ? "card " : "") + shown[color], made, name, shown[color],
                [leaves = shown_in(*look.leaves, shown[color]), color, pixels] {
                  return leaf_pictures(leaves, color, pixels);
                })
        .material;
  }
  if (tissue == Tissue::dew) made.color = {1, 1, 1}, made.gloss = 1.2, made.transmission = 0.95;
  if (!made.leaf || !laid) {
    made.factor = made.color;
    return keep(fmt::format("organ {}", static_cast<int>(tissue)), made, name, {}, {}).material;
  }
  Swatch swatch;
  swatch.includes = {tissue == Tissue::ivy ? "ivy" : "plant"};
  swatch.texture = tissue_text(tissue, made.color, organ.second, 1, organ.luster);
  int pixels = std::min(options_.texture, kLeafPixels);
  swatch.pixels = {pixels, pixels};
  swatch.repeats = false, swatch.spread = true;
  swatch.relief = organ.luster && organ.luster->relief > 0;
  return keep_swatch(std::move(swatch), made, name, 0.6).material;
}

std::size_t Palette::blade(const BladeLook& look, std::size_t color, const std::string& name) {
  Prototype blade{"blade", {{look.tissue, {}}}, look.colors, look.second};
  return organ({}, blade, 0, color, Lies::mesh, name);
}

Palette::Use Palette::body(const Look& look, const Material& material, const Solid* vessel,
                           const std::string& name) {
  ExportMaterial made;
  made.color = material.color, made.gloss = material.gloss;
  if (material.matter == Matter::glass) {
    // Light takes on the colour at each of the four faces of two walls: each gives a share of it.
    Vec3 face = glm::pow(linear(material.color), Vec3(kFaceOfGlass));
    made.color = srgb(face);
    made.transmission = 0.95, made.gloss = 1.2;
  }
  if (material.matter == Matter::pane) made.gloss = 1.1;
  if (material.matter == Matter::ceramic) made.gloss = 0.4 + 0.8 * material.gloss;
  if (!material.picture.empty())
    return keep(material.picture, made, name, material.picture,
                [=, picture = material.picture] { return worn(look, picture); });
  double rough = std::clamp(0.95 - 0.75 * made.gloss, 0.05, 1.0);
  bool patterned = row_of(material.matter).widths > 0;
  if (!patterned && !(vessel && !material.bands.empty())) {
    made.factor = made.color;
    return keep(fmt::format("body {} {}", made.gloss, made.transmission), made, name, {}, {});
  }
  return keep_swatch(
      vessel ? vessel_swatch(*vessel, material, options_.texture) : body_swatch(material, options_.texture),
      made, name, rough);
}

}  // namespace frond
