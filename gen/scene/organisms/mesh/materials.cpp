#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/content.h"
#include "images/read_picture.h"
#include "organisms/mesh/mesh.h"

namespace frond {

namespace {

constexpr double kOpaque = 0.999;

/// How a material of the file is drawn.
struct MaterialDrawing {
  std::optional<Color> color;  ///< none: as the preset says
  std::string picture;         ///< name of the picture that it wears; empty: none
  bool spread = false;         ///< whether that lies on by texture coordinates; else it is of one pixel
};

bool is_pictured(const MeshMaterial& m) { return m.picture && is_picture(*m.picture); }

/// Whether all corners of a part have texture coordinates.
bool has_texture(const MeshBody& body, std::int32_t material) {
  const Surface& s = body.cut.surface;
  if (s.paint.empty()) return false;
  for (std::size_t t = 0; t < s.triangle.size(); ++t)
    if (body.part[body.cut.part[t]].material == material)
      for (const Vec3& corner : s.paint[t])
        if (std::isnan(corner.x) || std::isnan(corner.y)) return false;
  return true;
}

std::string picture_of(const MeshMaterial& m) {
  Color c = m.color.value_or(Color{});
  std::string key = fmt::format("mesh {} {} {} {} ", c.red, c.green, c.blue, m.opacity);
  return fmt::format("mesh_{}.png", content_id(key + (is_pictured(m) ? *m.picture : "")));
}

/// The colour of a picture on average, times that of its material.
Color mean_of(const MeshMaterial& m) {
  Color tint = m.color.value_or(Color{});
  Result<Raster> read = read_texture(*m.picture);
  if (!read || read->data.empty()) return tint;
  std::array<double, 3> sum{};
  auto channels = static_cast<std::size_t>(read->channels);
  std::size_t pixels = read->data.size() / channels, step = 1 + pixels / 65536;
  double count = 0;
  for (std::size_t i = 0; i < pixels; i += step, ++count)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += read->data[i * channels + (channels == 1 ? 0 : c)];
  auto channel = [&](std::size_t c) { return static_cast<float>(sum[c] / (255 * count)); };
  return {tint.red * channel(0), tint.green * channel(1), tint.blue * channel(2)};
}

/// Whether the file's own materials are drawn at all.
bool draws_own_materials(const MeshParams& params) {
  return !params.own_color && std::ranges::any_of(params.body->material, [](const MeshMaterial& m) {
    return m.color || is_pictured(m);
  });
}

MaterialDrawing material_drawing(const MeshParams& params, std::int32_t material) {
  if (material < 0 || !draws_own_materials(params)) return {};
  const MeshMaterial& m = params.body->material[static_cast<std::size_t>(material)];
  if (!params.own_matter && is_pictured(m) && has_texture(*params.body, material))
    return {m.color.value_or(Color{}), picture_of(m), true};
  if (!params.own_matter && m.color && m.opacity < kOpaque) return {m.color, picture_of(m), false};
  return {m.color, {}, false};
}

/// The picture of a material: what the file names, times its colour, with its opacity.
Result<std::vector<Picture>> draw_picture(const MeshMaterial& m, bool spread, const std::string& name) {
  Raster from(1, 1, 3);
  std::ranges::fill(from.data, std::uint8_t{255});
  if (spread) {
    Result<Raster> read = read_texture(*m.picture);
    if (!read) return Error{m.picture_name, read.errors()[0].what};
    from = std::move(*read);
  }
  // Programs that write a picture and a black colour beside it mean the picture.
  Color tint = m.color.value_or(Color{});
  if (spread && tint.red + tint.green + tint.blue < 0.01f) tint = Color{};
  bool sheer = from.channels == 4 || m.opacity < kOpaque;
  Raster made(from.width, from.height, sheer ? 4 : 3);
  auto channel = [&](std::size_t pixel, int c) {
    return from.data[pixel * static_cast<std::size_t>(from.channels) +
                     static_cast<std::size_t>(from.channels == 1 ? 0 : c)];
  };
  std::size_t pixels = from.data.size() / static_cast<std::size_t>(from.channels);
  for (std::size_t i = 0; i < pixels; ++i) {
    std::size_t at = i * static_cast<std::size_t>(made.channels);
    for (int c = 0; c < 3; ++c) {
      float share = c == 0 ? tint.red : c == 1 ? tint.green : tint.blue;
      made.data[at + static_cast<std::size_t>(c)] =
          to_byte(static_cast<double>(share) * channel(i, c) / 255.0);
    }
    if (sheer) made.data[at + 3] = to_byte(m.opacity * (from.channels == 4 ? channel(i, 3) : 255) / 255.0);
  }
  Result<std::string> bytes = png_text(made);
  if (!bytes) return bytes.errors();
  return std::vector<Picture>{{name, std::move(*bytes)}};
}

/// The triangles of one drawing of a material, with texture coordinates where it wears a picture.
Surface part_of(const MeshBody& body, const std::vector<char>& taken, const MaterialDrawing& drawn) {
  const Surface& all = body.cut.surface;
  Surface part;
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> known;
  for (std::size_t t = 0; t < all.triangle.size(); ++t) {
    if (!taken[body.cut.part[t]]) continue;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t v = all.triangle[t][k];
      Vec2 uv = drawn.spread ? Vec2(all.paint[t][k]) : Vec2(0.5f);
      auto [place, fresh] =
          known.try_emplace({v, uv.x, uv.y}, static_cast<std::uint32_t>(part.position.size()));
      triangle[k] = place->second;
      if (!fresh) continue;
      part.position.push_back(all.position[v]);
      part.normal.push_back(all.normal[v]);
      if (!drawn.picture.empty()) part.uv.push_back(uv);
    }
    part.triangle.push_back(triangle);
    if (!all.paint.empty()) part.paint.push_back(all.paint[t]);
  }
  return part;
}

/// For each material that occurs, -1 of none, the parts that it has.
std::map<std::int32_t, std::vector<char>> parts_of(const MeshBody& body) {
  std::map<std::int32_t, std::vector<char>> parts;
  for (std::uint32_t p : body.cut.part) {
    std::vector<char>& taken = parts[body.part[p].material];
    taken.resize(body.part.size(), 0);
    taken[p] = 1;
  }
  return parts;
}

/// Its surface with those parts barred that carry nothing.
Surface barred_hull(const MeshParams& params) {
  Surface hull = params.body->cut.surface;
  hull.paint.resize(hull.triangle.size(), {kUnpainted, kUnpainted, kUnpainted});
  for (std::size_t t = 0; t < hull.triangle.size(); ++t)
    if (!params.body->bears(params.body->cut.part[t], params.carries))
      for (Vec3& corner : hull.paint[t]) corner.z = kBarred;
  for (Vec3& p : hull.position) p *= static_cast<float>(size_of(params));
  return hull;
}

std::string listed(const MeshParams& params, bool (*which)(const MeshMaterial&)) {
  std::string list;
  std::map<std::int32_t, std::vector<char>> used = parts_of(*params.body);
  for (const auto& [material, parts] : used)
    if (material >= 0)
      if (const MeshMaterial& m = params.body->material[static_cast<std::size_t>(material)]; which(m))
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", m.name);
  return list;
}

}  // namespace

Result<Model> build_mesh_model(const MeshParams& params) {
  if (!params.body) return Error{"", "file \"" + params.file.name + "\" has not been read"};
  const MeshBody& body = *params.body;
  Model model;
  Material matter{params.matter, params.color, params.second, params.scale};
  matter.moss = params.weathering;
  Vec3 size(static_cast<float>(size_of(params)));
  auto place = [&](Surface surface, const Material& material) {
    model.solids.place(model.solids.add_shape({std::move(surface), material}), Vec3(0), Quat(1, 0, 0, 0),
                       size);
  };
  if (!params.carries.empty()) model.hull = barred_hull(params);
  if (!draws_own_materials(params)) return place(body.cut.surface, matter), model;
  for (const auto& [which, taken] : parts_of(body)) {
    MaterialDrawing drawn = material_drawing(params, which);
    Material material = matter;
    if (drawn.color) material.color = *drawn.color;
    if (drawn.color && !params.own_matter) material.matter = Matter::plain;
    if (!drawn.picture.empty()) {
      material.matter = Matter::shell, material.picture = drawn.picture;
      material.second = Color{1, 1, 1}, material.gloss = 0;
      if (drawn.spread) material.color = mean_of(body.material[static_cast<std::size_t>(which)]);
    }
    place(part_of(body, taken, drawn), material);
  }
  return model;
}

std::vector<Drawing> mesh_pictures(const MeshParams& params) {
  std::vector<Drawing> drawings;
  if (!params.body) return drawings;
  for (const auto& [which, taken] : parts_of(*params.body)) {
    MaterialDrawing drawn = material_drawing(params, which);
    if (drawn.picture.empty()) continue;
    const MeshMaterial& m = params.body->material[static_cast<std::size_t>(which)];
    constexpr double kPixels = 1 << 20, kSecondsAPixel = 1e-7;  // of a usual one
    double pixels = drawn.spread ? kPixels : 1;
    drawings.push_back({{drawn.picture},
                        [m, drawn] { return draw_picture(m, drawn.spread, drawn.picture); },
                        pixels,
                        kSecondsAPixel * pixels});
  }
  return drawings;
}

Errors mesh_warnings(const MeshParams& params) {
  Errors warnings;
  if (!params.body) return warnings;
  const MeshBody& body = *params.body;
  for (const std::string& note : body.notes) warnings.push_back({"/file", params.file.name + " " + note});
  if (body.lies)
    warnings.push_back(
        {"/file",
         params.file.name + " looks as if it lay on its back; if z is up in it, write \"up\": \"z\""});
  auto colored = +[](const MeshMaterial& m) { return m.color || is_pictured(m); };
  auto pictured = +[](const MeshMaterial& m) { return is_pictured(m); };
  auto unread = +[](const MeshMaterial& m) { return m.picture && !is_pictured(m); };
  auto sheer = +[](const MeshMaterial& m) { return m.opacity < kOpaque; };
  auto warn = [&](const char* pointer, auto which, std::string_view before, std::string_view after) {
    if (std::string list = listed(params, which); !list.empty())
      warnings.push_back(error_at(pointer, "{} {}; {}", before, list, after));
  };
  if (params.own_color) {
    warn("/color", colored, "takes the place of the colours that the file gives its materials",
         "without it they have their own");
    return warnings;
  }
  if (params.own_matter) {
    warn("/matter", pictured, "takes the place of the pictures that the file gives its materials",
         "without it they wear them");
    warn("/matter", sheer, "is opaque, and the file lets light through its materials", "without it they do");
  }
  warn("/file", unread, params.file.name + " has pictures of an unknown kind on its materials",
       "expected PNG, JPEG or WebP, and they have one colour now");
  if (params.own_matter) return warnings;
  for (const auto& [which, taken] : parts_of(body))
    if (which >= 0 && is_pictured(body.material[static_cast<std::size_t>(which)]) &&
        !has_texture(body, which))
      warnings.push_back(error_at("/file",
                                  "{} gives its material \"{}\" a picture but not all of its corners texture "
                                  "coordinates; it has one colour",
                                  params.file.name, body.material[static_cast<std::size_t>(which)].name));
  return warnings;
}

}  // namespace frond
