#include "export/foliage.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <utility>

#include "geometry/far.h"
#include "scene/copies.h"

namespace frond {

namespace {

constexpr int kMostRows = 3;         // of a card
constexpr double kFewTriangles = 8;  // of an organ that is not yet a diamond
constexpr double kFine = 1e-9;       // metres: nothing is left out for its size

/// The triangles of one colour, each leaf's `uv` on its own 0..1. What has none is of the first.
Surface of_color(const Surface& leaves, std::size_t color, std::size_t colors) {
  Surface out;
  if (leaves.uv.empty()) return color == 0 ? leaves : out;
  std::vector<std::uint32_t> index(leaves.position.size(), UINT32_MAX);
  for (const auto& t : leaves.triangle) {
    if (color_index(leaves.uv[t[0]], colors) != color) continue;
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

/// Keeps one of so many organs of a prototype, grown about their middle to the area of all.
void thin_out(Organs& o, std::size_t which, const Surface& shape, int stride) {
  Organs kept;
  float larger = std::sqrt(static_cast<float>(stride));
  Vec3 middle(0);
  for (const Vec3& p : shape.position) middle += p / static_cast<float>(shape.position.size());
  int rank = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    bool own = o.prototype[i] == which;
    if (own && rank++ % stride != stride / 2) continue;
    kept.prototype.push_back(o.prototype[i]);
    Vec3 back = own ? (larger - 1) * o.scale[i] * (o.turn[i] * middle) : Vec3(0);
    kept.position.push_back(o.position[i] - back);
    kept.turn.push_back(o.turn[i]);
    kept.scale.push_back(o.scale[i] * (own ? larger : 1));
    kept.color.push_back(o.color[i]);
    kept.id.push_back(o.id[i]);
  }
  o = std::move(kept);
}

/// What each may take at most so that all together take no more than there is.
double level_of(std::vector<double> needs, double all) {
  std::sort(needs.begin(), needs.end());
  for (std::size_t i = 0; i < needs.size(); ++i) {
    double level = all / static_cast<double>(needs.size() - i);
    if (needs[i] > level) return level;
    all -= needs[i];
  }
  return needs.empty() ? 0 : needs.back() + 1;
}

std::size_t colors_of(const Prototype& prototype, std::size_t part) {
  return prototype.parts[part].tissue == Tissue::heart ? 1 : prototype.colors.size();
}

}  // namespace

Surface card_of(const Surface& leaf, int rows) {
  // Least squares: place = a + b u + c v + d v^2, the last where there are rows enough to bend.
  glm::dmat4 sums(0);
  DVec3 products[4] = {DVec3(0), DVec3(0), DVec3(0), DVec3(0)};
  auto terms = [&](Vec2 at) {
    auto u = static_cast<double>(at.x), v = static_cast<double>(at.y);
    return glm::dvec4(1, u, v, rows > 1 ? v * v : 0);
  };
  Vec3 up(0);
  for (std::size_t i = 0; i < leaf.position.size(); ++i) {
    glm::dvec4 w = terms(leaf.uv[i]);
    sums += glm::outerProduct(w, w);
    for (int k = 0; k < 4; ++k) products[k] += w[k] * DVec3(leaf.position[i]);
    up += leaf.normal[i];
  }
  if (rows < 2) sums[3][3] = 1;
  if (std::abs(glm::determinant(sums)) < 1e-12) return leaf;
  glm::dmat4 inverse = glm::inverse(sums);
  DVec3 fit[4];
  for (int k = 0; k < 4; ++k) {
    fit[k] = DVec3(0);
    for (int j = 0; j < 4; ++j) fit[k] += inverse[j][k] * products[j];
  }
  Surface card;
  for (int row = 0; row <= rows; ++row)
    for (float u : {0.0f, 1.0f}) {
      Vec2 at(u, static_cast<float>(row) / static_cast<float>(rows));
      glm::dvec4 w = terms(at);
      card.position.push_back(Vec3(w.x * fit[0] + w.y * fit[1] + w.z * fit[2] + w.w * fit[3]));
      card.uv.push_back(at);
    }
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    std::uint32_t k = 2 * row;
    card.triangle.push_back({k, k + 1, k + 3});
    card.triangle.push_back({k, k + 3, k + 2});
  }
  set_normals(card);
  if (glm::dot(card.normal[0], up) < 0) {
    for (auto& [i, j, k] : card.triangle) std::swap(j, k);
    set_normals(card);
  }
  return card;
}

std::vector<LeafPart> foliage_parts(const Look& look, Model model, double triangles) {
  std::vector<LeafPart> made;
  if (model.organs.size() == 0) return made;
  model.skeleton = {}, model.blades = {}, model.solids = {};
  std::vector<std::size_t> count(model.prototypes.size(), 0);
  for (std::uint16_t which : model.organs.prototype) ++count[which];
  double shapes = 0;
  std::vector<double> needs;
  for (std::size_t p = 0; p < model.prototypes.size(); ++p)
    for (const OrganPart& part : model.prototypes[p].parts)
      needs.push_back(static_cast<double>(count[p] * part.surface.triangle.size())), ++shapes;
  std::vector<bool> card(model.prototypes.size(), false);
  double share = level_of(needs, triangles);
  for (std::size_t p = 0; p < model.prototypes.size(); ++p) {
    OrganPart& leaf = model.prototypes[p].parts[0];
    auto times = static_cast<double>(count[p]);
    // What has no picture is drawn more simply as long as its shape allows it.
    for (OrganPart& part : model.prototypes[p].parts)
      if (double each = share / std::max(times, 1.0); part.pictures.empty() && each >= kFewTriangles)
        part.surface = reduced(part.surface, static_cast<std::size_t>(each));
    if (!look.leaves || leaf.pictures.empty() ||
        times * static_cast<double>(leaf.surface.triangle.size()) < share)
      continue;
    int rows = std::clamp(static_cast<int>(share / (2 * times)), 1, kMostRows);
    leaf.surface = card_of(leaf.surface, rows);
    card[p] = true;
    if (auto stride = static_cast<int>(std::ceil(2 * times / share)); stride > 1)
      thin_out(model.organs, p, leaf.surface, stride);
  }
  for (CopyPart& part : copy_parts(look, model, {kFine, (1.01 * share + 8) * shapes})) {
    if (part.kind != CopyPart::Kind::organ) continue;
    std::size_t colors = colors_of(model.prototypes[part.which], part.part);
    for (std::size_t k = 0; k < colors; ++k)
      if (Surface leaves = of_color(part.surface, k, colors); !leaves.triangle.empty())
        made.push_back({part.which, part.part, k, card[part.which], std::move(leaves)});
  }
  return made;
}

}  // namespace frond
