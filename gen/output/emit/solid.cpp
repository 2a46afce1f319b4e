#include "emit/solid.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/content.h"
#include "core/text.h"
#include "emit/mask.h"

namespace frond {

namespace {

/// A shape that is placed oftener than this has one texture for all its placements, which lies in the world:
/// each texture of its own costs memory.
constexpr std::size_t kOwnTextures = 32;

void append_macro(std::string& text, std::string_view macro, const Material& material) {
  text += macro;
  text += '(';
  if (!material.picture.empty()) text += '"' + material.picture + "\",";
  append_color(text, material.color);
  text += ',';
  append_color(text, material.second);
  text += ',';
  append_list(text, 5, material.scale, material.relief, material.moss, material.gloss);
  text += ")}";
}

/// The texture, on it the bands and water, and what is inside.
void append_material(std::string& text, const Material& material, bool wet) {
  const MatterRow& row = row_of(material.matter);
  text += " texture{";
  append_macro(text, row.macro, material);
  if (material.polyps.glow > 0) {
    text.back() = ' ';  // the texture goes on
    text += "Reef_Glow(";
    append(text, material.polyps.glow, 4);
    text += ")}";
  }
  for (const Band& band : material.bands) {
    text += "texture{Vessel_Band(";
    append_color(text, band.color);
    text += ',';
    append_list(text, 5, band.at, band.width, material.gloss);
    text += ',';
    append_integer(text, static_cast<int>(band.motif));
    text += ',';
    append_integer(text, band.repeats);
    text += ")}";
  }
  if (std::optional<Wetting> wetting = wetting_of(material.matter); wet && wetting)
    text += weather_over(false, true, *wetting);
  if (row.inside.empty()) return;
  text += "interior{";
  append_macro(text, row.inside, material);
}

/// A body that POV-Ray turns itself. The mirror of z changes nothing about it.
void append_lathe(std::string& text, const PovSpace& space, const Solid& solid) {
  text += "lathe{bezier_spline ";
  append_integer(text, static_cast<long long>(4 * solid.turned.size()));
  for (const auto& span : solid.turned)
    for (const glm::dvec2& p : span) {
      text += ",<";
      append_list(text, 6, p.x * space.unit, p.y * space.unit);
      text += '>';
    }
  text += " sturm}";
}

/// `Solid2_0`: a shape of an organism.
void append_solid_name(std::string& text, std::size_t organism, std::size_t shape) {
  text += "Solid";
  append_integer(text, static_cast<long long>(organism));
  text += '_';
  append_integer(text, static_cast<long long>(shape));
}

/// The field of a blob over q = d^2.
std::string_view falloff_text(Falloff falloff) {
  switch (falloff) {
    case Falloff::gaussian:
      return "exp(-R*Q)";
    case Falloff::soft:
      return "select(Q - R*R, 1 - 22*Q/(9*R*R) + 17*Q*Q/(9*pow(R, 4)) - 4*Q*Q*Q/(9*pow(R, 6)), 0)";
    case Falloff::cubic:
      return "pow(max(0, 1 - Q/(R*R)), 3)";
  }
  return {};
}

/// Appends an isosurface in the solid's own space, without a texture. The field stands mirrored in POV-Ray's.
void append_isosurface(std::string& text, const PovSpace& space, const Isosurface& iso) {
  text += "isosurface{\n#local F = function(Q, R) {";
  text += falloff_text(iso.blobs.falloff);
  text += "}\nfunction{";
  append(text, iso.blobs.level, 9);
  for (const Blob& blob : iso.blobs.blobs) {
    text += "\n-F(";
    for (int axis = 0; axis < 3; ++axis) {
      text += axis == 0 ? "pow(x/" : axis == 1 ? "+pow(y/" : "+pow(-z/";
      append(text, blob.radius[axis], 9);
      text += "-(";
      append(text, blob.center[axis], 9);
      text += "),2)";
    }
    text += ',';
    append(text, std::max(blob.radius.x, std::max(blob.radius.y, blob.radius.z)), 9);
    text += ')';
  }
  text += "}\ncontained_by{box{<";
  append_list(text, 6, iso.box.low.x, iso.box.low.y, -iso.box.high.z);
  text += ">,<";
  append_list(text, 6, iso.box.high.x, iso.box.high.y, -iso.box.low.z);
  text += ">}} max_gradient ";
  append(text, iso.steepest, 6);
  text += " accuracy ";
  append(text, 0.0001 * iso.box.size().y, 9);
  text += "\ntranslate<";
  append_list(text, 9, -iso.origin.x, -iso.origin.y, iso.origin.z);
  text += "> scale ";
  append(text, iso.unit * space.unit, 9);
  text += '}';
}

[[nodiscard]] bool append_placement(std::string& text, const PovSpace& space, const OrganPlace& place) {
  return append_matrix(text, space, axes_of(place.turn, place.scale), place.at);
}

/// One of its own for each picture and each way that it lies.
std::string moss_map_name(const Mask& mask) {
  auto axis = static_cast<int>(mask.along.value_or(Axis::y));
  Vec2 from = mask.area[0], to = mask.area[1];
  return "Moss_Map_" +
         content_id(fmt::format("{} {} {} {} {} {}", mask.file.content, axis, from.x, from.y, to.x, to.y));
}

/// Declares the map of a material's moss, and what it looks like without moss and with it.
void declare_mapped(std::string& text, const PovSpace& space, const Material& material, bool wet) {
  std::string map = moss_map_name(*material.moss_map);
  text += "#ifndef(" + map + ")\n";
  declare_mask(text, space, *material.moss_map, map);
  text += "#end\n#declare Bare =";
  Material bare = material;
  bare.moss = 0;
  append_material(text, bare, wet);
  text += "\n#declare Mossy =";
  append_material(text, material, wet);
  text += '\n';
}

/// What goes over between the two by the map, which lies in the world; `matrix` places them as their body.
std::string mapped_texture(const Material& material, std::string_view matrix) {
  return fmt::format("texture{{function{{{0}(x,y,z)}} texture_map{{[0 Bare {1}][1 Mossy {1}]}}}}",
                     moss_map_name(*material.moss_map), matrix);
}

/// A shape that is the same for a while: declared once and placed.
void append_shape(ObjectText& all, const PovSpace& space, const DrawnBody& body, std::size_t organism,
                  bool wet) {
  std::string lines, &text = all.text;
  std::size_t placed = 0;
  const Solid& solid = *body.solid;
  bool own = body.places.size() <= kOwnTextures;
  bool mapped = solid.material.moss_map && solid.material.moss > 0;
  auto worn = [&](std::string_view matrix) { return mapped_texture(solid.material, matrix); };
  if (mapped) declare_mapped(text, space, solid.material, wet);
  text += "#declare ";
  append_solid_name(text, organism, body.shape);
  text += " = ";
  if (solid.native)
    append_isosurface(text, space, *solid.native);
  else if (solid.turned.empty())
    append_mesh(text, space, with_light_uv(solid.surface, solid));
  else
    append_lathe(text, space, solid);
  text += '\n';
  for (const OrganPlace& place : body.places) {
    std::size_t line = lines.size();
    lines += "object{";
    append_solid_name(lines, organism, body.shape);
    lines += ' ';
    if (own && !mapped) append_material(lines, solid.material, wet);
    std::size_t matrix = lines.size();
    if (!append_placement(lines, space, place)) {
      lines.resize(line);
      continue;
    }
    if (own && mapped) lines += worn(lines.substr(matrix));
    lines += "}\n", ++placed;
  }
  if (own || lines.empty()) {
    text += lines;
    all.objects += placed;
    return;
  }
  ++all.objects;
  text += "union{\n" + lines;
  if (mapped)
    text += worn("");
  else
    append_material(text, solid.material, wet);
  text += "}\n";
}

/// One that is another in each frame.
void append_grown(ObjectText& all, const PovSpace& space, const DrawnBody& body, bool wet) {
  std::string object = "object{\n";
  append_mesh(object, space, with_light_uv(*body.now, *body.solid));
  append_material(object, body.solid->material, wet);
  for (const OrganPlace& place : body.places) {
    std::string whole = object;
    if (append_placement(whole, space, place)) all += {whole + "}\n", 1};
  }
}

}  // namespace

void append_front(std::string& text, double front) {
  text += "#declare Reef_Front = ";
  append(text, front, 4);
  text += ";\n";
}

std::string material_text(const Material& material) {
  std::string text;
  append_material(text, material, false);
  return text;
}

std::string_view material_include(const Material& material) { return row_of(material.matter).include; }

std::vector<std::string_view> solid_includes(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const Specimen& b : scene.specimens)
    for (const Solid& solid : b.model.solids.shapes) names.push_back(material_include(solid.material));
  for (const Specimen& b : scene.specimens)
    if (b.look.branches.polyps()) names.push_back("reef");
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

ObjectText solid_text(const PovSpace& space, const DrawnBody& body, std::size_t organism, bool wet) {
  ObjectText text;
  if (!has_faces(body.surface())) return text;
  if (is_of_reef(body.solid->material.matter)) append_front(text.text, body.front);
  if (body.now)
    append_grown(text, space, body, wet);
  else
    append_shape(text, space, body, organism, wet);
  return text;
}

ObjectText solids_text(const PovSpace& space, const Scene& scene, const DrawnSolids& drawn) {
  ObjectText text;
  for (std::size_t o = 0; o < scene.specimens.size(); ++o) {
    const Specimen& b = scene.specimens[o];
    const Solids& solids = drawn.of(scene, o);
    if (solids.size() == 0 || b.life.develop) continue;
    append_comment(text.text, b.name);
    for (const DrawnBody& body : still_bodies(solids, b.motion.growth))
      text += solid_text(space, body, o, b.wet);
  }
  return text;
}

}  // namespace frond
