#include "accretion/sheet_body.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

using Edge = std::array<std::uint32_t, 2>;

constexpr float kNoLimit = 1e3f;  // metres that no sheet is thick

/// Edges of one triangle alone, as it runs through them.
std::vector<Edge> open_edges(const Sheet& sheet) {
  struct Side {
    Edge ends, directed;
  };
  std::vector<Side> sides;
  for (auto [a, b, c] : sheet.triangle)
    for (Edge e : {Edge{a, b}, Edge{b, c}, Edge{c, a}})
      sides.push_back({{std::min(e[0], e[1]), std::max(e[0], e[1])}, e});
  std::ranges::sort(sides, [](const Side& p, const Side& q) {
    return p.ends != q.ends ? p.ends < q.ends : p.directed < q.directed;
  });
  std::vector<Edge> open;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].ends == sides[i].ends) ++j;
    if (j == i + 1) open.push_back(sides[i].directed);
    i = j;
  }
  return open;
}

std::vector<Vec3> even_normals(const Sheet& sheet) {
  std::vector<Vec3> normal = sheet.normal;
  for (int round = 0; round < 2; ++round) {
    std::vector<Vec3> sum(normal);
    for (auto [a, b, c] : sheet.triangle) {
      sum[a] += 0.5f * (normal[b] + normal[c]);
      sum[b] += 0.5f * (normal[c] + normal[a]);
      sum[c] += 0.5f * (normal[a] + normal[b]);
    }
    for (std::size_t v = 0; v < normal.size(); ++v)
      normal[v] = direction_or(sum[v] + normal[v] * 1e-3f, normal[v]);
  }
  return normal;
}

/// What each vertex had at a row, of what it has for good: as sheet_at().
std::vector<Vec3> back_then(const Sheet& sheet, const std::vector<Vec3>& last, float row) {
  std::vector<Vec3> then(last.size());
  for (std::size_t v = 0; v < last.size(); ++v) {
    auto [p, q] = sheet.parents[v];
    float there = std::clamp(row - (sheet.row[v] - 1), 0.0f, 1.0f);
    then[v] = p == v ? last[v] : glm::mix((then[p] + then[q]) * 0.5f, last[v], there);
  }
  return then;
}

/// How far from the sheet its sides may be, that they do not cross where it is bent: shares of its radius.
std::vector<float> bend_limits(const Sheet& sheet, const std::vector<Vec3>& normal) {
  constexpr float kOfRadius = 0.55f;  // share of the radius of a bend
  constexpr float kSlope = 0.4f;      // metres by which it changes at most, a metre along the sheet
  std::vector<float> limit(normal.size(), kNoLimit);
  for (auto [a, b, c] : sheet.triangle)
    for (auto [p, q] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
      float turn = glm::distance(normal[p], normal[q]);
      float radius = kOfRadius * glm::distance(sheet.position[p], sheet.position[q]) / std::max(turn, 1e-4f);
      limit[p] = std::min(limit[p], radius), limit[q] = std::min(limit[q], radius);
    }
  // It changes gently from place to place.
  for (int round = 0; round < 3; ++round)
    for (auto [a, b, c] : sheet.triangle)
      for (auto [p, q] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
        float near = kSlope * glm::distance(sheet.position[p], sheet.position[q]);
        limit[p] = std::min(limit[p], limit[q] + near), limit[q] = std::min(limit[q], limit[p] + near);
      }
  return limit;
}

/// The vertices of the body at one time: the upper side, the lower one and the edge between.
class Layers {
 public:
  Layers(const Sheet& sheet, const SheetSkin& skin) : sheet_(sheet), skin_(skin), open_(open_edges(sheet)) {
    normal_ = even_normals(sheet);
    if (skin.plumb)
      for (Vec3& n : normal_) n = Vec3(0, 1, 0);
    limit_ = skin.plumb ? std::vector<float>(normal_.size(), kNoLimit) : bend_limits(sheet, normal_);
    std::vector<Vec3> away(sheet.position.size(), Vec3(0));
    for (auto [a, b] : open_) {
      Vec3 out = glm::cross(sheet.position[b] - sheet.position[a], sheet.normal[a] + sheet.normal[b]);
      float length = glm::length(out);
      if (length > 0) away[a] += out / length, away[b] += out / length;
    }
    edge_.assign(sheet.position.size(), ~0u);
    for (auto [a, b] : open_)
      for (std::uint32_t v : {a, b})
        if (edge_[v] == ~0u) {
          edge_[v] = static_cast<std::uint32_t>(rim_.size());
          rim_.push_back(v);
          Vec3 out = away[v] - normal_[v] * glm::dot(away[v], normal_[v]);
          float length = glm::length(out);
          out_.push_back(length > 1e-4f ? out / length : Vec3(0));
        }
  }

  std::vector<Vec3> at(float row) const {
    constexpr float kSprout = 0.04f;   // of its size, at first
    constexpr float kLinesAge = 0.1f;  // of the whole growth, by which growth lines stand out
    constexpr float kBlunt = 0.45f;    // of the thickness: how far the edge goes beyond the rim
    constexpr float kThick = 0.02f;    // metres: of what is thicker, the edge is blunt
    bool now = row >= static_cast<float>(sheet_.rows);
    std::vector<Vec3> middle = now ? sheet_.position : back_then(sheet_, sheet_.position, row);
    std::vector<Vec3> normal = now || skin_.plumb ? normal_ : back_then(sheet_, normal_, row);
    auto rows = static_cast<float>(sheet_.rows);
    auto swell = [&](Vec3 p) {
      if (skin_.sprout <= 0) return p;
      return p * (kSprout + 0.96f * smooth_step(0.0f, static_cast<float>(skin_.sprout), row / rows));
    };
    std::size_t count = middle.size();
    std::vector<Vec3> all(2 * count + rim_.size());
    for (std::uint32_t v = 0; v < count; ++v) {
      float age = std::max(0.0f, std::min(row, sheet_.end[v]) - sheet_.row[v]) / rows;
      float n2 = glm::dot(normal[v], normal[v]);
      Vec3 n = n2 > 1e-8f ? normal[v] / std::sqrt(n2) : normal_[v];
      float relief = static_cast<float>(skin_.lines) * (line(v) - 0.5f) * smooth_step(0.0f, kLinesAge, age);
      all[v] = swell(middle[v] + n * std::min(limit_[v], skin_.upper(v, age) + relief));
      all[count + v] = swell(middle[v] - n * std::min(limit_[v], skin_.lower(v, age) + relief));
    }
    for (std::size_t e = 0; e < rim_.size(); ++e) {
      Vec3 up = all[rim_[e]], down = all[count + rim_[e]];
      all[2 * count + e] =
          (up + down) * 0.5f + out_[e] * (kBlunt * std::min(glm::distance(up, down), kThick));
    }
    return all;
  }

  /// 0 between growth lines .. 1 on one.
  float line(std::uint32_t v) const {
    float phase = sheet_.distance[v] / static_cast<float>(skin_.line);
    return 0.5f + 0.5f * std::sin(2 * static_cast<float>(kPi) * phase);
  }

  std::vector<std::array<std::uint32_t, 3>> triangles() const {
    std::vector<std::array<std::uint32_t, 3>> list = sheet_.triangle;
    auto count = static_cast<std::uint32_t>(sheet_.position.size());
    for (auto [a, b, c] : sheet_.triangle) list.push_back({c + count, b + count, a + count});
    for (auto [a, b] : open_) {
      std::uint32_t ea = 2 * count + edge_[a], eb = 2 * count + edge_[b];
      list.push_back({b, a, ea});
      list.push_back({b, ea, eb});
      list.push_back({eb, ea, a + count});
      list.push_back({eb, a + count, b + count});
    }
    return list;
  }

  std::vector<Vec2> uv() const {
    std::vector<Vec2> list;
    auto share = [&](std::uint32_t v) { return sheet_.row[v] / static_cast<float>(sheet_.rows); };
    auto count = static_cast<std::uint32_t>(sheet_.position.size());
    for (std::uint32_t v = 0; v < count; ++v) list.push_back({0.4f + 0.6f * line(v), share(v)});
    for (std::uint32_t v = 0; v < count; ++v) list.push_back({0.3f + 0.4f * line(v), share(v)});
    for (std::uint32_t v : rim_) list.push_back({1.0f, share(v)});
    return list;
  }

 private:
  const Sheet& sheet_;
  const SheetSkin& skin_;
  std::vector<Edge> open_;
  std::vector<Vec3> normal_;
  std::vector<float> limit_;
  std::vector<std::uint32_t> edge_;  // of each vertex, its number among those of the edge
  std::vector<std::uint32_t> rim_;
  std::vector<Vec3> out_;
};

}  // namespace

std::vector<Vec3> sheet_at(const Sheet& sheet, float row) { return back_then(sheet, sheet.position, row); }

SheetBody body_of(const Sheet& sheet, const SheetSkin& skin) {
  Layers layers(sheet, skin);
  SheetBody body;
  body.sides = static_cast<std::uint32_t>(sheet.position.size());
  body.surface.position = layers.at(static_cast<float>(sheet.rows));
  body.surface.triangle = layers.triangles();
  body.surface.uv = layers.uv();
  set_normals(body.surface);
  for (int k = 0; k < kSheetSteps; ++k)
    body.past.push_back(layers.at(static_cast<float>(k * sheet.rows) / kSheetSteps));
  return body;
}

}  // namespace frond
