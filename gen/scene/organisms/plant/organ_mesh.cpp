#include "organisms/plant/organ_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "core/content.h"
#include "geometry/mesh_file.h"
#include "images/read_picture.h"

namespace frond {

namespace {

/// Gives a mesh without `uv` that of a petal: 0 on its axis, 1 at its rim.
void set_uv(Surface& mesh) {
  if (!mesh.uv.empty()) return;
  for (const Vec3& at : mesh.position)
    mesh.uv.emplace_back(std::min(1.0f, 2 * glm::length(Vec2(at.x, at.z))), 0.5f);
}

bool has_place(const std::array<Vec3, 3>& corners) {
  for (const Vec3& corner : corners)
    if (std::isnan(corner.x) || std::isnan(corner.y)) return false;
  return true;
}

/// The tile of the repeated picture that a triangle lies in; the first where it lies in several.
Vec2 tile_of(const std::array<Vec3, 3>& corners) {
  const Vec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
  const Vec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
  auto tile = [](float from, float to) {
    if (from >= 0 && to <= 1) return 0.0f;
    return to - std::floor(from) <= 1 ? std::floor(from) : 0.0f;
  };
  return {tile(low.x, high.x), tile(low.y, high.y)};
}

/// The triangles that wear the picture, whose vertices are those that share place and texture coordinates;
/// or the others.
Surface part_of(const OrganParams& organ, bool pictured) {
  const Surface& all = organ.mesh;
  Surface part;
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> known;
  for (std::size_t t = 0; t < all.triangle.size(); ++t) {
    if (static_cast<bool>(organ.skin->worn[t]) != pictured) continue;
    const Vec2 tile = pictured ? tile_of(all.paint[t]) : Vec2(0);
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = all.triangle[t][k];
      const Vec2 uv = pictured ? Vec2(all.paint[t][k]) - tile : Vec2(0);
      const auto [place, fresh] =
          known.try_emplace({v, uv.x, uv.y}, static_cast<std::uint32_t>(part.position.size()));
      triangle[k] = place->second;
      if (!fresh) continue;
      part.position.push_back(all.position[v]);
      part.normal.push_back(all.normal[v]);
      if (pictured) part.uv.push_back(uv);
    }
    part.triangle.push_back(triangle);
  }
  return part;
}

/// What the picture is multiplied by, for one of the organ's colours.
Color tint_of(const OrganParams& organ, std::size_t color) {
  Color tint = organ.skin->tint;
  // Programs that write a picture and a black colour beside it mean the picture.
  if (tint.red + tint.green + tint.blue < 0.01f) tint = Color{};
  if (!organ.own_colors) return tint;
  const Color& own = organ.colors[color];
  return {tint.red * own.red, tint.green * own.green, tint.blue * own.blue};
}

std::size_t colors_of(const OrganParams& organ) { return organ.own_colors ? organ.colors.size() : 1; }

std::string picture_name(const OrganParams& organ, std::size_t color) {
  const Color c = tint_of(organ, color);
  return fmt::format("organ_{}.png",
                     content_id(fmt::format("{} {} {} ", c.red, c.green, c.blue) + organ.skin->id));
}

/// Share of a pixel that is there, and its channels.
struct Texel {
  double share = 1;
  std::array<double, 3> channel{};
};

Texel texel_of(const Raster& raster, std::size_t i) {
  const auto channels = static_cast<std::size_t>(raster.channels);
  Texel texel;
  if (channels == 4) texel.share = raster.data[i * channels + 3] / 255.0;
  for (std::size_t c = 0; c < 3; ++c)
    texel.channel[c] = raster.data[i * channels + (channels == 1 ? 0 : c)] / 255.0;
  return texel;
}

std::size_t pixels_of(const Raster& raster) {
  return static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
}

/// The picture in a tint, its mean where it has opacity, which organs do not show.
Result<Raster> tinted(const OrganSkin& skin, const Color& tint) {
  Result<Raster> read = read_texture(*skin.picture);
  if (!read) return Error{skin.name, read.errors()[0].what};
  Raster made(read->width, read->height, 3);
  const float share[] = {tint.red, tint.green, tint.blue};
  const float mean[] = {skin.mean.red, skin.mean.green, skin.mean.blue};
  for (std::size_t i = 0; i < pixels_of(made); ++i) {
    const Texel texel = texel_of(*read, i);
    for (std::size_t c = 0; c < 3; ++c)
      made.data[3 * i + c] =
          to_byte(static_cast<double>(share[c]) *
                  (texel.share * texel.channel[c] + (1 - texel.share) * static_cast<double>(mean[c])));
  }
  return made;
}

/// The picture on average, as some of its pixels tell: what the organ looks like where no picture is shown.
Color mean_of(const Raster& picture) {
  constexpr std::size_t kAsked = 1 << 16;
  const std::size_t pixels = pixels_of(picture), step = (pixels + kAsked - 1) / kAsked;
  std::array<double, 3> sum{};
  double shares = 0;
  for (std::size_t i = 0; i < pixels; i += step) {
    const Texel texel = texel_of(picture, i);
    shares += texel.share;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += texel.share * texel.channel[c];
  }
  if (shares <= 0) return {};
  auto channel = [&](std::size_t c) { return static_cast<float>(sum[c] / shares); };
  return {channel(0), channel(1), channel(2)};
}

/// The picture of a material, measured; nothing where it has none that is read, which `tell` is told.
template <class Tell>
std::optional<OrganSkin> skin_of(const MeshMaterial& material, const Tell& tell) {
  if (!material.picture) return std::nullopt;
  Result<Raster> read = read_texture(*material.picture);
  if (!read) {
    tell(fmt::format("names the picture \"{}\", which {}; it has one colour", material.picture_name,
                     read.errors()[0].what));
    return std::nullopt;
  }
  bool sheer = false;
  for (std::size_t i = 0; read->channels == 4 && i < pixels_of(*read); ++i)
    sheer = sheer || texel_of(*read, i).share < 1;
  if (sheer)
    tell(fmt::format("names the picture \"{}\", which has opacity; organs do not show it",
                     material.picture_name));
  return OrganSkin{.picture = material.picture,
                   .name = material.picture_name,
                   .tint = material.color.value_or(Color{}),
                   .worn = {},
                   .mean = mean_of(*read),
                   .id = content_id(*material.picture),
                   .pixels = static_cast<double>(pixels_of(*read))};
}

}  // namespace

Errors load_organ_mesh(const NamedFile& file, OrganParams& organ) {
  std::string others;
  Result<PolygonMesh> read = read_mesh_file(file, &others);
  if (!read) return read.errors();
  Result<PartedSurface> made = parted_surface(*read, unit_frame(*read), file.path.string());
  if (!made) return made.errors();
  if (!others.empty()) organ.file.content = content_id(organ.file.content + others);
  organ.mesh = std::move(made->surface);
  organ.skin.reset(), organ.mesh_note.clear();
  auto tell = [&](const std::string& note) {
    organ.mesh_note += (organ.mesh_note.empty() ? organ.file.name + ' ' : "; ") + note;
  };
  for (const std::string& note : read->notes) tell(note);
  // The first material with a picture that all of its corners have a place on.
  for (std::size_t m = 0; m < read->material.size() && !organ.skin; ++m) {
    const MeshMaterial& material = read->material[m];
    std::optional<OrganSkin> skin = skin_of(material, tell);
    if (!skin) continue;
    bool whole = true, any = false;
    for (std::size_t t = 0; t < organ.mesh.triangle.size(); ++t) {
      const bool own = read->part[made->part[t]].material == static_cast<std::int32_t>(m);
      skin->worn.push_back(own);
      any = any || own;
      whole = whole && (!own || (!organ.mesh.paint.empty() && has_place(organ.mesh.paint[t])));
    }
    if (any && whole) {
      organ.skin = std::move(skin);
    } else if (any) {
      tell(fmt::format(
          "gives its material \"{}\" a picture but not all of its corners texture coordinates; it has one "
          "colour",
          material.name));
    }
  }
  return {};
}

void add_organ_mesh(Prototype& to, const OrganParams& organ) {
  if (!organ.skin) {
    to.parts.push_back({Tissue::petal, organ.mesh});
    set_uv(to.parts.back().surface);
    return;
  }
  OrganPart worn{Tissue::petal, part_of(organ, true)};
  to.colors.clear();
  for (std::size_t i = 0; i < colors_of(organ); ++i) {
    const Color tint = tint_of(organ, i), mean = organ.skin->mean;
    worn.pictures.push_back(picture_name(organ, i));
    to.colors.push_back({tint.red * mean.red, tint.green * mean.green, tint.blue * mean.blue});
  }
  to.parts.push_back(std::move(worn));
  if (Surface rest = part_of(organ, false); !rest.triangle.empty())
    to.parts.push_back({Tissue::heart, std::move(rest)});
}

std::vector<Drawing> organ_mesh_drawings(const OrganParams& organ) {
  constexpr double kSecondsAPixel = 1e-7;
  std::vector<Drawing> all;
  for (std::size_t i = 0; organ.skin && i < colors_of(organ); ++i) {
    std::string name = picture_name(organ, i);
    auto draw = [skin = *organ.skin, tint = tint_of(organ, i), name]() -> Result<std::vector<Picture>> {
      Result<Raster> made = tinted(skin, tint);
      if (!made) return made.errors();
      Result<std::string> bytes = png_text(*made);
      if (!bytes) return bytes.errors();
      return std::vector<Picture>{{name, std::move(*bytes)}};
    };
    all.push_back({{name}, std::move(draw), organ.skin->pixels, kSecondsAPixel * organ.skin->pixels});
  }
  return all;
}

}  // namespace frond
