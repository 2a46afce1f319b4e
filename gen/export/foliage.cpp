#include "export/foliage.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "scene/copies.h"

namespace frond {

namespace {

constexpr double kFine = 1e-9;  // metres: nothing is left out for its size

/// The triangles of one colour, each leaf's `uv` on its own 0..1. What has none is of the first.
Surface of_color(const Surface& leaves, std::size_t color, std::size_t colors) {
  Surface out;
  if (leaves.uv.empty()) return color == 0 ? leaves : out;
  std::vector<std::uint32_t> index(leaves.position.size(), UINT32_MAX);
  for (const auto& t : leaves.triangle) {
    if (color_index(static_cast<std::int32_t>(std::floor(leaves.uv[t[0]].x)), colors) != color) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& at = index[t[c]];
      if (at == UINT32_MAX) {
        at = static_cast<std::uint32_t>(out.position.size());
        out.position.push_back(leaves.position[t[c]]);
        out.normal.push_back(leaves.normal[t[c]]);
        out.uv.push_back({leaves.uv[t[c]].x - std::floor(leaves.uv[t[c]].x), leaves.uv[t[c]].y});
      }
      corners[c] = at;
    }
    out.triangle.push_back(corners);
  }
  return out;
}

/// Keeps one of so many organs of a prototype, grown to the area of all.
void thin_out(Organs& o, std::size_t which, int stride) {
  Organs kept;
  float larger = std::sqrt(static_cast<float>(stride));
  int rank = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    bool own = o.prototype[i] == which;
    if (own && rank++ % stride != stride / 2) continue;
    kept.prototype.push_back(o.prototype[i]);
    kept.position.push_back(o.position[i]);
    kept.turn.push_back(o.turn[i]);
    kept.scale.push_back(o.scale[i] * (own ? larger : 1));
    kept.color.push_back(o.color[i]);
    kept.id.push_back(o.id[i]);
  }
  o = std::move(kept);
}

std::size_t colors_of(const Prototype& prototype, std::size_t part) {
  return prototype.parts[part].tissue == Tissue::heart ? 1 : prototype.colors.size();
}

}  // namespace

Surface card_of(const Surface& leaf) {
  // Least squares: place = a + b u + c v.
  glm::dmat3 sums(0);
  DVec3 sum_u[3] = {DVec3(0), DVec3(0), DVec3(0)};
  Vec3 up(0);
  for (std::size_t i = 0; i < leaf.position.size(); ++i) {
    DVec3 w(1, leaf.uv[i].x, leaf.uv[i].y), p(leaf.position[i]);
    sums += glm::outerProduct(w, w);
    for (int k = 0; k < 3; ++k) sum_u[k] += w[k] * p;
    up += leaf.normal[i];
  }
  if (std::abs(glm::determinant(sums)) < 1e-12) return leaf;
  glm::dmat3 inverse = glm::inverse(sums);
  DVec3 fit[3];
  for (int k = 0; k < 3; ++k)
    fit[k] = inverse[0][k] * sum_u[0] + inverse[1][k] * sum_u[1] + inverse[2][k] * sum_u[2];
  Surface card;
  Vec3 normal = glm::normalize(Vec3(glm::cross(fit[1], fit[2])));
  if (glm::dot(normal, up) < 0) normal = -normal;
  for (Vec2 at : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
    card.position.push_back(Vec3(fit[0] + fit[1] * double(at.x) + fit[2] * double(at.y)));
    card.normal.push_back(normal);
    card.uv.push_back(at);
  }
  card.triangle = {{0, 1, 2}, {0, 2, 3}};
  Vec3 turned = glm::cross(card.position[1] - card.position[0], card.position[2] - card.position[0]);
  if (glm::dot(turned, normal) < 0) card.triangle = {{0, 2, 1}, {0, 3, 2}};
  return card;
}

std::vector<LeafPart> foliage_parts(const Look& look, Model model, double triangles) {
  std::vector<LeafPart> made;
  if (model.organs.size() == 0) return made;
  model.skeleton = {}, model.blades = {}, model.solids = {};
  std::vector<std::size_t> count(model.prototypes.size(), 0);
  for (std::uint16_t which : model.organs.prototype) ++count[which];
  double shapes = 0;
  for (const Prototype& prototype : model.prototypes) shapes += static_cast<double>(prototype.parts.size());
  std::vector<bool> card(model.prototypes.size(), false);
  double share = triangles / shapes;
  for (std::size_t p = 0; p < model.prototypes.size(); ++p) {
    OrganPart& leaf = model.prototypes[p].parts[0];
    auto times = static_cast<double>(count[p]);
    if (!look.leaves || leaf.pictures.empty() ||
        times * static_cast<double>(leaf.surface.triangle.size()) < share)
      continue;
    leaf.surface = card_of(leaf.surface);
    card[p] = true;
    if (auto stride = static_cast<int>(std::ceil(2 * times / share)); stride > 1)
      thin_out(model.organs, p, stride);
  }
  for (CopyPart& part : copy_parts(look, model, {kFine, 1.01 * triangles + 8 * shapes})) {
    if (part.kind != CopyPart::Kind::organ) continue;
    std::size_t colors = colors_of(model.prototypes[part.which], part.part);
    for (std::size_t k = 0; k < colors; ++k)
      if (Surface leaves = of_color(part.surface, k, colors); !leaves.triangle.empty())
        made.push_back({part.which, part.part, k, card[part.which], std::move(leaves)});
  }
  return made;
}

}  // namespace frond
