#include "export/foliage.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <utility>

#include "core/seed.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr int kMostRows = 3;         // of a card
constexpr double kFewTriangles = 8;  // of a piece that is not yet a diamond
constexpr double kAlike = 0.03;      // of an area: no less is as good as all
constexpr float kShut = 0.2f;  // of a piece's area, that its triangles face together: less of a closed body

/// What a piece of a surface adds up to.
struct PieceArea {
  float area = 0;
  Vec3 facing{0}, middle{0};  // middle times area
};

std::vector<PieceArea> areas_of(const Surface& s, const Pieces& pieces) {
  std::vector<PieceArea> list(pieces.count);
  for (auto [a, b, c] : s.triangle) {
    Vec3 across = glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]) * 0.5f;
    PieceArea& piece = list[pieces.of[a]];
    piece.area += glm::length(across);
    piece.facing += across;
    piece.middle += (s.position[a] + s.position[b] + s.position[c]) * (glm::length(across) / 3);
  }
  return list;
}

/// The area that the pieces show: of a closed body a quarter of its surface.
double shown_area(const Surface& s, const Pieces& pieces) {
  double sum = 0;
  for (const PieceArea& piece : areas_of(s, pieces))
    sum += static_cast<double>(piece.area) * (glm::length(piece.facing) < kShut * piece.area ? 0.25 : 1);
  return sum;
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

Vec3 middle_of(const Surface& shape) {
  Vec3 middle(0);
  for (const Vec3& p : shape.position) middle += p / static_cast<float>(shape.position.size());
  return middle;
}

/// Adds an organ where it is, its place on its picture within that picture.
void append_organ(Surface& to, const Surface& shape, Vec3 at, Quat turn, Vec3 scale) {
  auto first = static_cast<std::uint32_t>(to.position.size());
  for (const Vec3& p : shape.position) to.position.push_back(at + turn * (scale * p));
  for (const Vec3& n : shape.normal) to.normal.push_back(turn * n);
  // A place at the far rim would be one on the next leaf.
  for (const Vec2& uv : shape.uv) to.uv.push_back(glm::clamp(uv, Vec2(0.001f), Vec2(0.999f)));
  for (auto [a, b, c] : shape.triangle) to.triangle.push_back({first + a, first + b, first + c});
}

/// How the organs of one prototype are drawn.
struct OrganShapes {
  std::vector<Surface> parts;
  bool card = false;  // the first of them
  int stride = 1;     // how many one stands for
  LeafSize size;
};

/// In about so many triangles each part.
OrganShapes shapes_of(const Look& look, const Prototype& prototype, double count, double scale, double share,
                      const FoliageDetail& detail, const LeafSize& most) {
  OrganShapes made;
  double each = share / count, wanted = 1;
  for (std::size_t k = 0; k < prototype.parts.size(); ++k) {
    const OrganPart& part = prototype.parts[k];
    Surface shape = part.tissue == Tissue::dew ? Surface{} : part.surface;  // which from there is not seen
    if (static_cast<double>(shape.triangle.size()) > each) {
      if (k == 0 && part.tissue == Tissue::leaf && detail.pictures && look.leaves && !part.pictures.empty()) {
        shape = card_of(shape, std::clamp(static_cast<int>(each / 2), 1, kMostRows));
        made.card = true;
      } else if (is_leaf(part.tissue)) {
        shape = fewer_leaves(shape, each, most.edge / scale);
      } else {
        double least = std::max(each, kFewTriangles / 2);
        Surface fewer = reduced(shape, static_cast<std::size_t>(least));
        // What is of many pieces has no fewer edges to give.
        shape = static_cast<double>(fewer.triangle.size()) <= 2 * least
                    ? std::move(fewer)
                    : fewer_leaves(shape, each, most.edge / scale);
      }
      wanted = std::max(wanted, std::ceil(static_cast<double>(shape.triangle.size()) / each - 1e-6));
    }
    made.parts.push_back(std::move(shape));
  }
  made.size.edge = 0;
  for (const Surface& shape : made.parts)
    made.size.edge = std::max(made.size.edge, longest_edge(shape) * scale);
  double room = made.card ? most.larger : most.edge / std::max(made.size.edge, 1e-9);
  wanted = std::min({wanted, std::max(1.0, std::floor(room * room)), count});
  made.stride = static_cast<int>(wanted);
  made.size.larger = std::sqrt(wanted);
  made.size.edge *= made.size.larger;
  return made;
}

/// The organs of a prototype as meshes of one colour each, one of `stride` grown in place of all.
void merge_organs(std::vector<LeafPart>& made, const Model& model, std::size_t which,
                  const OrganShapes& shapes) {
  const Prototype& prototype = model.prototypes[which];
  const Organs& o = model.organs;
  std::size_t first = made.size();
  std::vector<std::size_t> begin;  // of each part's colours
  for (std::size_t k = 0; k < prototype.parts.size(); ++k) {
    begin.push_back(made.size());
    std::size_t colors = prototype.parts[k].tissue == Tissue::heart ? 1 : prototype.colors.size();
    for (std::size_t c = 0; c < colors; ++c)
      made.push_back({which, k, c, k == 0 && shapes.card, {}, shapes.size});
  }
  Vec3 middle = middle_of(shapes.parts[0]);
  auto larger = static_cast<float>(shapes.size.larger);
  int rank = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    if (o.prototype[i] != which || rank++ % shapes.stride != shapes.stride / 2) continue;
    Vec3 at = o.position[i] - (larger - 1) * (o.turn[i] * (o.scale[i] * middle));
    std::size_t color = color_index(o.color[i], prototype.colors.size());
    for (std::size_t k = 0; k < shapes.parts.size(); ++k) {
      std::size_t colors = (k + 1 < begin.size() ? begin[k + 1] : made.size()) - begin[k];
      append_organ(made[begin[k] + (colors > 1 ? color : 0)].surface, shapes.parts[k], at, o.turn[i],
                   larger * o.scale[i]);
    }
  }
  made.erase(std::remove_if(made.begin() + static_cast<std::ptrdiff_t>(first), made.end(),
                            [](const LeafPart& part) { return part.surface.triangle.empty(); }),
             made.end());
}

/// The box of all organs in full.
Bounds box_of(const Model& model) {
  Bounds box;
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i)
    for (const OrganPart& part : model.prototypes[o.prototype[i]].parts)
      for (const Vec3& p : part.surface.position)
        if (part.tissue != Tissue::dew) box.extend(o.position[i] + o.turn[i] * (o.scale[i] * p));
  return box;
}

}  // namespace

double longest_edge(const Surface& s) {
  float longest = 0;
  for (const auto& t : s.triangle)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(s.position[t[k]], s.position[t[(k + 1) % 3]]));
  return static_cast<double>(longest);
}

void grow_pieces(Surface& s, float factor) {
  Pieces pieces = pieces_of(s);
  std::vector<PieceArea> list = areas_of(s, pieces);
  for (std::size_t v = 0; v < s.position.size(); ++v) {
    const PieceArea& piece = list[pieces.of[v]];
    if (piece.area > 0) s.position[v] = glm::mix(piece.middle / piece.area, s.position[v], factor);
  }
}

Surface fewer_leaves(const Surface& surface, double triangles, double longest) {
  Pieces pieces = pieces_of(surface);
  double shown = shown_area(surface, pieces);
  if (triangles >= kFewTriangles * pieces.count) {
    Surface made = reduced(surface, static_cast<std::size_t>(triangles));
    bool alike = std::abs(shown_area(made, pieces_of(made)) - shown) < kAlike * shown;
    if (alike && longest_edge(made) <= longest) return made;
  }
  // A diamond for each piece, then for several of them.
  int stride = std::clamp(static_cast<int>(std::ceil(2 * pieces.count / triangles)), 1,
                          std::max(1, static_cast<int>(pieces.count) / 2));
  for (;; stride = stride * 3 / 4) {
    Surface made = far_leaves(surface, pieces, stride);
    if (made.triangle.empty() || made.triangle.size() >= surface.triangle.size()) return surface;
    double covered = area(made);
    if (covered > 0) grow_pieces(made, static_cast<float>(std::sqrt(shown / covered)));
    if (stride == 1 || longest_edge(made) <= longest) return made;
  }
}

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

void keep_in_box(std::vector<LeafPart>& parts, const Bounds& box) {
  struct Piece {
    std::size_t part;
    std::uint32_t number;
    Bounds box;
    Vec3 by{0};
  };
  std::vector<Piece> list;
  std::vector<std::size_t> begin;  // of each part's pieces
  std::vector<Pieces> pieces;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Surface& s = parts[p].surface;
    pieces.push_back(pieces_of(s));
    begin.push_back(list.size());
    for (std::uint32_t k = 0; k < pieces[p].count; ++k) list.push_back({p, k, {}});
    for (std::size_t v = 0; v < s.position.size(); ++v)
      list[begin[p] + pieces[p].of[v]].box.extend(s.position[v]);
  }
  if (list.empty() || box.empty()) return;
  for (Piece& piece : list) {
    if (piece.box.empty()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      float under = box.low[axis] - piece.box.low[axis], over = piece.box.high[axis] - box.high[axis];
      if (under > 0 && over > 0)
        piece.by[axis] = (under - over) / 2;
      else
        piece.by[axis] = std::max(under, 0.0f) - std::max(over, 0.0f);
    }
    piece.box.low += piece.by, piece.box.high += piece.by;
  }
  for (int axis = 0; axis < 3; ++axis) {
    auto low = std::ranges::min_element(list, {}, [&](const Piece& p) { return p.box.low[axis]; });
    low->by[axis] += box.low[axis] - low->box.low[axis];
    auto high = std::ranges::max_element(list, {}, [&](const Piece& p) { return p.box.high[axis]; });
    if (high != low) high->by[axis] += box.high[axis] - high->box.high[axis];
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t v = 0; v < parts[p].surface.position.size(); ++v)
      parts[p].surface.position[v] += list[begin[p] + pieces[p].of[v]].by;
}

std::map<std::size_t, LeafSize> most_larger(const std::vector<LeafPart>& parts) {
  std::map<std::size_t, LeafSize> most;
  for (const LeafPart& part : parts)
    most[part.prototype] = {kLargerLeaves * part.size.edge, kLargerLeaves * part.size.larger};
  return most;
}

std::vector<LeafPart> foliage_parts(const Look& look, const Model& model, const FoliageDetail& detail) {
  std::vector<LeafPart> made;
  const Organs& o = model.organs;
  if (o.size() == 0) return made;
  std::vector<std::size_t> count(model.prototypes.size(), 0);
  std::vector<double> scale(model.prototypes.size(), 0);
  for (std::size_t i = 0; i < o.size(); ++i) {
    ++count[o.prototype[i]];
    scale[o.prototype[i]] = std::max(
        scale[o.prototype[i]], static_cast<double>(std::max({o.scale[i].x, o.scale[i].y, o.scale[i].z})));
  }
  std::vector<double> needs;
  for (std::size_t p = 0; p < model.prototypes.size(); ++p)
    for (const OrganPart& part : model.prototypes[p].parts)
      if (count[p] > 0) needs.push_back(static_cast<double>(count[p] * part.surface.triangle.size()));
  double share = level_of(needs, detail.triangles);
  bool fewer = false;
  for (std::size_t p = 0; p < model.prototypes.size(); ++p) {
    if (count[p] == 0) continue;
    auto most = detail.most.find(p);
    OrganShapes shapes = shapes_of(look, model.prototypes[p], static_cast<double>(count[p]), scale[p], share,
                                   detail, most == detail.most.end() ? LeafSize{} : most->second);
    fewer |= shapes.stride > 1 || shapes.card;
    merge_organs(made, model, p, shapes);
  }
  if (fewer && !detail.moves) keep_in_box(made, box_of(model));
  return made;
}

}  // namespace frond
