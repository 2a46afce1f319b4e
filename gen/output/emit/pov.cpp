#include "emit/pov.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "geometry/far.h"

namespace frond {

namespace {

/// Decimals of numbers that are right to `step`.
int decimals_of(double step, int least, int most) {
  return step > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(2 * step) - 1e-9)), least, most) : most;
}

/// Whether a matrix has an inverse when it is rounded to so many decimals: as one of whole numbers, whose
/// determinant is a whole number, too.
bool has_inverse(const glm::mat3& m, int decimals) {
  glm::dmat3 whole = glm::dmat3(m) * std::pow(10.0, decimals);
  for (int axis = 0; axis < 3; ++axis) whole[axis] = glm::round(whole[axis]);
  double box = glm::length(whole[0]) * glm::length(whole[1]) * glm::length(whole[2]);
  return std::abs(glm::determinant(whole)) > std::max(0.5, 1e-12 * box);
}

/// Whether the normals are those of the triangles, or nearly.
bool is_flat(const Surface& s, float cosine) {
  if (cosine > 1) return false;
  return std::ranges::all_of(s.triangle, [&](const auto& t) {
    Vec3 across = glm::cross(s.position[t[1]] - s.position[t[0]], s.position[t[2]] - s.position[t[0]]);
    float area = glm::length(across);
    return std::ranges::all_of(t, [&](std::uint32_t v) {
      return std::abs(glm::dot(across, s.normal[v])) >= cosine * area * glm::length(s.normal[v]);
    });
  });
}

/// A triangle that POV-Ray would refuse.
bool is_sliver(const Surface& surface, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vec3& p = surface.position[a];
  Vec3 area = glm::cross(surface.position[b] - p, surface.position[c] - p);
  return glm::dot(area, area) < 1e-20f;
}

}  // namespace

PovSpace space_for(double thinnest_radius) {
  PovSpace space;
  while (thinnest_radius * space.unit < kThinnest && space.unit < 1000) space.unit *= 10;
  return space;
}

int decimals_for(const PovSpace& space, double pixel) {
  return decimals_of(pixel / 20 * space.unit, 1, kDecimals);
}

MatrixText matrix_text_for(const PovSpace& space, double reach, double pixel) {
  return {decimals_of(pixel / 20 / std::max(reach, 1e-6), 2, 5), decimals_for(space, pixel)};
}

std::string weather_over(bool snowy, bool wet, Wetting wetting) {
  std::string text = wet ? fmt::format("texture{{{}}}", row_of(wetting).texture) : "";
  return snowy ? text + "texture{Snow_Over}" : text;
}

void append_point(std::string& text, const PovSpace& space, Vec3 at, int decimals) {
  append_vector(text, decimals, at.x * space.unit, at.y * space.unit, -at.z * space.unit);
}

void append_light(std::string& text, Vec3 light) {
  append_vector(text, kDecimals, light.r, light.g, light.b);
}

void append_direction(std::string& text, Vec3 direction) {
  append_vector(text, kDecimals, direction.x, direction.y, -direction.z);
}

bool append_matrix(std::string& text, const PovSpace& space, const glm::mat3& m, Vec3 shift,
                   const MatrixText& how) {
  int decimals = has_inverse(m, how.decimals) ? how.decimals : has_inverse(m, 5) ? 5 : 9;
  if (!has_inverse(m, decimals)) return false;
  // POV-Ray multiplies row vectors: its rows are the images of its axes. The mirror turns both sides.
  text += "matrix<";
  for (int axis = 0; axis < 3; ++axis) {
    float sign = axis == 2 ? -1.0f : 1.0f;
    append_list(text, decimals, sign * m[axis].x, sign * m[axis].y, -sign * m[axis].z);
    text += ',';
  }
  append_list(text, how.shift_decimals, shift.x * space.unit, shift.y * space.unit, -shift.z * space.unit);
  text += '>';
  return true;
}

void append_object(std::string& text, const PovSpace& space, std::string_view name, const glm::mat3& matrix,
                   Vec3 shift, const MatrixText& how) {
  std::size_t line = text.size();
  text += "object{";
  text += name;
  text += ' ';
  if (append_matrix(text, space, matrix, shift, how))
    text += "}\n";
  else
    text.resize(line);
}

void append_color(std::string& text, const Color& color) {
  text += "srgb";
  append_vector(text, 4, color.red, color.green, color.blue);
}

void declare_mask(std::string& text, const PovSpace& space, const Mask& mask, const std::string& name) {
  Axis axis = mask.along.value_or(Axis::y);
  Vec2 low = glm::min(mask.area[0], mask.area[1]), size = glm::max(mask.area[0], mask.area[1]) - low;
  // Pictures repeat: beyond the middles of its outer pixels it is as there.
  auto share = [&](std::string_view of, int i) {
    double half = 0.5 / (i == 0 ? mask.width : mask.height);
    return fmt::format("min({},max({},({}-({}))/{}))", number_text(1 - half, 6), number_text(half, 6), of,
                       number_text(low[i] * space.unit, 6),
                       number_text(std::max(size[i], 1e-6f) * space.unit, 6));
  };
  std::string across = share(axis == Axis::x ? "-z" : "x", 0), up = share(axis == Axis::y ? "-z" : "y", 1);
  text += fmt::format(
      "#declare {0}_Picture = function{{pigment{{image_map{{png \"{1}\" gamma 1 interpolate 2}}}}}}\n"
      "#declare {0} = function(x,y,z){{{0}_Picture({2},{3},0).red}}\n",
      name, mask.picture_name(), across, axis == Axis::y ? "1-" + up : up);
}

void append_comment(std::string& text, std::string_view words) {
  text += "// ";
  for (char c : words) text += static_cast<unsigned char>(c) < 32 || c == '\x7f' ? ' ' : c;
  text += '\n';
}

std::string_view group_opening(std::string_view lines) {
  return std::count(lines.begin(), lines.end(), '\n') > 1 ? "union{\n" : "object{\n";
}

bool has_faces(const Surface& surface) {
  return std::ranges::any_of(surface.triangle,
                             [&](const auto& t) { return !is_sliver(surface, t[0], t[1], t[2]); });
}

void append_mesh(std::string& text, const PovSpace& space, const Surface& surface, const MeshText& how) {
  text += "mesh2{\n";
  append_items(text, "vertex_vectors", surface.position,
               [&](Vec3 p) { append_point(text, space, p, how.decimals); });
  if (!is_flat(surface, how.flat))
    append_items(text, "normal_vectors", surface.normal,
                 [&](Vec3 n) { append_vector(text, 3, n.x, n.y, -n.z); });
  if (!surface.uv.empty() && how.uv_decimals >= 0)
    append_items(text, "uv_vectors", surface.uv,
                 [&](Vec2 at) { append_vector(text, how.uv_decimals, at.x, at.y); });
  text += "face_indices{";
  std::size_t count = 0, place = text.size();
  text.append(9, ' ');  // room for the count
  for (auto [a, b, c] : surface.triangle) {
    if (is_sliver(surface, a, b, c)) continue;
    // The mirror turns the triangle over, and this turns it back.
    text += ',';
    append_vector(text, 0, a, c, b);
    ++count;
  }
  std::string digits = std::to_string(count);
  text.replace(place, digits.size(), digits);
  text += "}}";
}

bool append_sweep(std::string& text, const PovSpace& space, const Skeleton& rest, const Pose& pose,
                  const Chunk& chunk, double within, int decimals) {
  std::int32_t below = rest.parent[chunk.first];
  bool forks = below != chunk.first - 1;
  std::vector<glm::vec4> points;  // with the radius
  auto add = [&](Vec3 at, float radius) {
    if (points.empty() || glm::distance(at, Vec3(points.back())) * space.unit >= 2e-4)
      points.emplace_back(at, std::max(radius, static_cast<float>(kThinnest / space.unit)));
  };
  add(pose.position[below], forks ? foot_radius(rest, pose, chunk.first) : pose.radius[below]);
  for (std::int32_t i = chunk.first; i <= chunk.last; ++i) add(pose.position[i], pose.radius[i]);
  if (points.size() < 2) return false;
  std::vector<char> kept(points.size(), within <= 0);
  if (within > 0) mark_bends(points, static_cast<float>(within), kept);
  text += "sphere_sweep{linear_spline ";
  append_integer(text, std::ranges::count(kept, 1));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!kept[i]) continue;
    text += ',';
    append_point(text, space, Vec3(points[i]), decimals);
    text += ',';
    append(text, points[i].w * space.unit, kDecimals);
  }
  return true;
}

}  // namespace frond
