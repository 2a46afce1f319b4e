#include "emit/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/content.h"
#include "emit/worn.h"

namespace frond {

namespace {

/// A shape that is placed oftener than this has one texture for all its placements, which lies in the world:
/// each texture of its own costs memory.
constexpr std::size_t kOwnTextures = 32;

std::string macro_text(std::string_view macro, const Material& m) {
  std::string color = m.picture.empty() ? "" : '"' + m.picture + "\",";
  append_color(color, m.color);
  return call_text(macro, color, m.second, m.scale, m.relief, m.moss, m.gloss);
}

/// A body that POV-Ray turns itself. The mirror of z changes nothing about it.
void append_lathe(std::string& text, const PovSpace& space, const Solid& solid) {
  text += fmt::format("lathe{{bezier_spline {}", 4 * solid.turned.size());
  for (const auto& span : solid.turned)
    for (const glm::dvec2& p : span) {
      text += ',';
      append_vector(text, 6, p.x * space.unit, p.y * space.unit);
    }
  text += " sturm}";
}

/// The field of a blob over q = d^2, of each Falloff.
constexpr std::string_view kFalloffs[] = {
    "exp(-R*Q)", "select(Q - R*R, 1 - 22*Q/(9*R*R) + 17*Q*Q/(9*pow(R, 4)) - 4*Q*Q*Q/(9*pow(R, 6)), 0)",
    "pow(max(0, 1 - Q/(R*R)), 3)"};

/// Appends an isosurface in the solid's own space, without a texture. The field stands mirrored in POV-Ray's.
void append_isosurface(std::string& text, const PovSpace& space, const Isosurface& iso) {
  text +=
      fmt::format("isosurface{{\n#local F = function(Q, R) {{{}}}\nfunction{{{}",
                  kFalloffs[static_cast<std::size_t>(iso.blobs.falloff)], number_text(iso.blobs.level, 9));
  for (const Blob& blob : iso.blobs.blobs) {
    text += "\n-F(";
    for (int axis = 0; axis < 3; ++axis)
      text += fmt::format("{}/{}-({}),2)",
                          axis == 0   ? "pow(x"
                          : axis == 1 ? "+pow(y"
                                      : "+pow(-z",
                          number_text(blob.radius[axis], 9), number_text(blob.center[axis], 9));
    text += ',' + number_text(std::max({blob.radius.x, blob.radius.y, blob.radius.z}), 9) + ')';
  }
  text += "}\ncontained_by{box{";
  append_vector(text, 6, iso.box.low.x, iso.box.low.y, -iso.box.high.z);
  text += ',';
  append_vector(text, 6, iso.box.high.x, iso.box.high.y, -iso.box.low.z);
  text += fmt::format("}}}} max_gradient {} accuracy {}\ntranslate", number_text(iso.steepest, 6),
                      number_text(0.0001 * iso.box.size().y, 9));
  append_vector(text, 9, -iso.origin.x, -iso.origin.y, iso.origin.z);
  text += " scale " + number_text(iso.unit * space.unit, 9) + '}';
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
  text += material_text(bare, wet) + "\n#declare Mossy =" + material_text(material, wet) + '\n';
}

/// What goes over between the two by the map, which lies in the world; `matrix` places them as their body.
std::string mapped_texture(const Material& material, std::string_view matrix) {
  return fmt::format("texture{{function{{{0}(x,y,z)}} texture_map{{[0 Bare {1}][1 Mossy {1}]}}}}",
                     moss_map_name(*material.moss_map), matrix);
}

/// A shape that is the same for a while: declared once and placed. `worn`: in what each frame
/// declares, see emit/worn.h.
void append_shape(ObjectText& all, const PovSpace& space, const DrawnBody& body, std::size_t organism,
                  bool wet, bool worn) {
  std::string lines, &text = all.text;
  std::size_t placed = 0;
  const Solid& solid = *body.solid;
  bool own = body.places.size() <= kOwnTextures;
  bool mapped = solid.material.moss_map && solid.material.moss > 0;
  auto laid = [&](std::string_view matrix) { return mapped_texture(solid.material, matrix); };
  const std::string texture = worn     ? ' ' + worn_name(organism, body.shape) + "()"
                              : mapped ? ""
                                       : material_text(solid.material, wet);
  if (mapped) declare_mapped(text, space, solid.material, wet);
  std::string name = fmt::format("Solid{}_{}", organism, body.shape);
  text += "#declare " + name + " = ";
  if (solid.native)
    append_isosurface(text, space, *solid.native);
  else if (solid.turned.empty())
    append_mesh(text, space, with_light_uv(solid.surface, solid));
  else
    append_lathe(text, space, solid);
  text += '\n';
  for (const OrganPlace& place : body.places) {
    std::size_t line = lines.size();
    lines += "object{" + name + ' ';
    if (own && !mapped) lines += texture;
    std::size_t matrix = lines.size();
    if (!append_matrix(lines, space, axes_of(place.turn, place.scale), place.at)) {
      lines.resize(line);
      continue;
    }
    if (own && mapped) lines += laid(lines.substr(matrix));
    lines += "}\n", ++placed;
  }
  if (own || lines.empty()) {
    text += lines;
    all.objects += placed;
    return;
  }
  ++all.objects;
  text += "union{\n" + lines + (mapped ? laid("") : texture) + "}\n";
}

/// One that is another in each frame.
void append_grown(ObjectText& all, const PovSpace& space, const DrawnBody& body, bool wet) {
  std::string object = "object{\n";
  append_mesh(object, space, with_light_uv(*body.now, *body.solid));
  object += material_text(body.solid->material, wet);
  for (const OrganPlace& place : body.places) {
    std::string whole = object;
    if (append_matrix(whole, space, axes_of(place.turn, place.scale), place.at)) all += {whole + "}\n", 1};
  }
}

/// A layer over living tissue: what of it has died.
std::string dead_text(const Material& material) {
  std::string patches = array_text(material.dead, [](std::string& text, const DeadPatch& patch) {
    append_vector(text, 4, patch.at.x, patch.at.y, -patch.at.z, patch.radius);
  });
  return "texture{Reef_Dead(" + patches + ',' + number_text(material.scale, 4) + ")}";
}

}  // namespace

void append_front(std::string& text, double front) {
  text += "#declare Reef_Front = " + number_text(front, 4) + ";\n";
}

std::string material_text(const Material& material, bool wet) {
  const MatterRow& row = row_of(material.matter);
  std::string text = " texture{" + macro_text(row.macro, material);
  if (material.polyps.glow > 0) text += " Reef_Glow(" + number_text(material.polyps.glow, 4) + ')';
  text += '}';
  if (!material.dead.empty()) text += dead_text(material);
  for (const Band& band : material.bands) {
    append_call(text += "texture{", "Vessel_Band", band.color, band.at, band.width, material.gloss,
                static_cast<int>(band.motif), band.repeats);
    text += '}';
  }
  if (std::optional<Wetting> wetting = wetting_of(material.matter); wet && wetting)
    text += weather_over(false, true, *wetting);
  if (!row.inside.empty()) text += "interior{" + macro_text(row.inside, material) + '}';
  return text;
}

std::string_view material_include(const Material& material) { return row_of(material.matter).include; }

std::vector<std::string_view> solid_includes(const Scene& scene) {
  std::set<std::string_view> names;
  for (const Specimen& b : scene.specimens) {
    for (const Solid& solid : b.model.solids.shapes) names.insert(material_include(solid.material));
    if (b.look.branches.polyps()) names.insert("reef");
    const std::optional<Condition>& condition = b.life.condition;
    if (condition && condition->courses.health && condition->courses.health->fluoresces > 0)
      names.insert("reef");
  }
  return {names.begin(), names.end()};
}

ObjectText solid_text(const PovSpace& space, const DrawnBody& body, std::size_t organism, bool wet,
                      bool worn) {
  ObjectText text;
  if (!has_faces(body.surface())) return text;
  if (is_of_reef(body.solid->material.matter)) append_front(text.text, body.front);
  if (body.now)
    append_grown(text, space, body, wet);
  else
    append_shape(text, space, body, organism, wet, worn);
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
      text += solid_text(space, body, o, b.wet, b.life.condition.has_value());
  }
  return text;
}

}  // namespace frond
