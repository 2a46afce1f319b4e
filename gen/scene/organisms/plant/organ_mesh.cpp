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

/// The triangles that wear the picture, whose vertices are those that share place and texture coordinates;
/// or the others.
Surface part_of(const OrganParams& organ, bool pictured) {
  const Surface& all = organ.mesh;
  Surface part;
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> known;
  for (std::size_t t = 0; t < all.triangle.size(); ++t) {
    if (static_cast<bool>(organ.skin->worn[t]) != pictured) continue;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = all.triangle[t][k];
      const Vec2 uv = pictured ? Vec2(all.paint[t][k]) : Vec2(0);
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
                     content_id(fmt::format("{} {} {} ", c.red, c.green, c.blue) + *organ.skin->picture));
}

Result<Raster> tinted(const OrganSkin& skin, const Color& tint) {
  Result<Raster> read = read_texture(*skin.picture);
  if (!read) return Error{skin.name, read.errors()[0].what};
  Raster made(read->width, read->height, 3);
  const float share[] = {tint.red, tint.green, tint.blue};
  const auto channels = static_cast<std::size_t>(read->channels);
  for (std::size_t i = 0; i < made.data.size() / 3; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      made.data[3 * i + c] =
          to_byte(static_cast<double>(share[c]) * read->data[i * channels + (channels == 1 ? 0 : c)] / 255.0);
  return made;
}

/// The picture on average: what the organ looks like where no picture is shown.
Color mean_of(const OrganSkin& skin) {
  Result<Raster> read = tinted(skin, Color{});
  if (!read || read->data.empty()) return {};
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < read->data.size(); ++i) sum[i % 3] += read->data[i];
  auto channel = [&](std::size_t c) {
    return static_cast<float>(sum[c] / (255.0 * static_cast<double>(read->data.size() / 3)));
  };
  return {channel(0), channel(1), channel(2)};
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
  // The first material with a picture that all of its corners have a place on.
  for (std::size_t m = 0; m < read->material.size() && !organ.skin; ++m) {
    const MeshMaterial& material = read->material[m];
    if (!material.picture || !is_picture(*material.picture)) continue;
    OrganSkin skin{material.picture, material.picture_name, material.color.value_or(Color{}), {}};
    bool whole = true, any = false;
    for (std::size_t t = 0; t < organ.mesh.triangle.size(); ++t) {
      const bool own = read->part[made->part[t]].material == static_cast<std::int32_t>(m);
      skin.worn.push_back(own);
      any = any || own;
      whole = whole && (!own || (!organ.mesh.paint.empty() && has_place(organ.mesh.paint[t])));
    }
    if (any && whole) {
      skin.mean = mean_of(skin);
      organ.skin = std::move(skin);
    } else if (any) {
      organ.mesh_note = fmt::format(
          "{} gives its material \"{}\" a picture but not all of its corners texture coordinates; it has one "
          "colour",
          organ.file.name, material.name);
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
  constexpr double kPixels = 1 << 20, kSecondsAPixel = 1e-7;  // of a usual one
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
    all.push_back({{name}, std::move(draw), kPixels, kSecondsAPixel * kPixels});
  }
  return all;
}

}  // namespace frond
