#include "emit/solid.h"

#include <algorithm>

#include "core/text.h"
#include "motion/motion.h"

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

/// The texture, on it the bands, and what is inside.
void append_material(std::string& text, const Material& material) {
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

[[nodiscard]] bool append_placement(std::string& text, const PovSpace& space, const Solids& solids,
                                    std::size_t i) {
  glm::mat3 frame = glm::mat3_cast(solids.turn[i]);
  for (int axis = 0; axis < 3; ++axis) frame[axis] *= solids.scale[i][axis];
  return append_matrix(text, space, frame, solids.position[i]);
}

void append_shape(ObjectText& all, const PovSpace& space, const Solids& solids, std::size_t organism,
                  std::size_t shape) {
  std::string lines, &text = all.text;
  std::size_t placed = 0;
  auto count = static_cast<std::size_t>(std::count(solids.shape.begin(), solids.shape.end(), shape));
  if (count == 0) return;
  const Solid& solid = solids.shapes[shape];
  bool own = count <= kOwnTextures;
  if (is_of_reef(solid.material.matter)) append_front(text, 1);
  text += "#declare ";
  append_solid_name(text, organism, shape);
  text += " = ";
  if (solid.native)
    append_isosurface(text, space, *solid.native);
  else if (solid.turned.empty())
    append_mesh(text, space, with_light_uv(solid.surface, solid));
  else
    append_lathe(text, space, solid);
  text += '\n';
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (solids.shape[i] != shape) continue;
    std::size_t line = lines.size();
    lines += "object{";
    append_solid_name(lines, organism, shape);
    lines += ' ';
    if (own) append_material(lines, solid.material);
    if (append_placement(lines, space, solids, i))
      lines += "}\n", ++placed;
    else
      lines.resize(line);
  }
  if (own || lines.empty()) {
    text += lines;
    all.objects += placed;
    return;
  }
  ++all.objects;
  text += "union{\n" + lines;
  append_material(text, solid.material);
  text += "}\n";
}

}  // namespace

void append_front(std::string& text, double front) {
  text += "#declare Reef_Front = ";
  append(text, std::min(front, 1.0), 4);
  text += ";\n";
}

std::string material_text(const Material& material) {
  std::string text;
  append_material(text, material);
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

ObjectText solids_text(const PovSpace& space, const Scene& scene, const DrawnSolids& drawn) {
  ObjectText text;
  for (std::size_t o = 0; o < scene.specimens.size(); ++o) {
    const Specimen& b = scene.specimens[o];
    const Solids& solids = solids_of(drawn, scene, o);
    if (solids.size() == 0 || b.life.develop) continue;
    append_comment(text.text, b.name);
    for (std::size_t s = 0; s < solids.shapes.size(); ++s)
      if (!is_growing(solids.shapes[s], b.motion.growth)) append_shape(text, space, solids, o, s);
  }
  return text;
}

ObjectText developed_solids_text(const PovSpace& space, const Solids& solids, std::size_t organism) {
  ObjectText text;
  for (std::size_t s = 0; s < solids.shapes.size(); ++s)
    if (has_faces(solids.shapes[s].surface)) append_shape(text, space, solids, organism, s);
  return text;
}

ObjectText growing_solids_text(const PovSpace& space, const Solids& solids, const Growth& growth,
                               double time) {
  ObjectText text;
  auto front = static_cast<float>(growth_front(growth, time));
  if (front <= 0) return text;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids.shapes[solids.shape[i]];
    if (!is_growing(solid, growth)) continue;
    Surface now = surface_at(solid, front);
    std::string object = "object{\n";
    if (!has_faces(now)) continue;
    append_mesh(object, space, with_light_uv(std::move(now), solid));
    append_material(object, solid.material);
    if (!append_placement(object, space, solids, i)) continue;
    if (is_of_reef(solid.material.matter)) append_front(text.text, front);
    text += {object + "}\n", 1};
  }
  return text;
}

}  // namespace frond
