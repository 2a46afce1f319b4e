#include "accretion/skin_mesh.h"

#include <algorithm>
#include <tuple>

namespace frond {

namespace {

using Triangle = SkinMesh::Triangle;

/// An edge of a triangle: the one from its corner `k` to the next.
struct Side {
  std::uint64_t key;  // of its two vertices, the lower first
  std::uint32_t triangle;
  std::uint32_t k;
};

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return a < b ? (static_cast<std::uint64_t>(a) << 32) | b : (static_cast<std::uint64_t>(b) << 32) | a;
}

/// The sides whose ends are `wanted`, those of an edge one after the other, in the order of their vertices:
/// sorted by counting, as most vertices have but a few.
template <class Wanted>
std::vector<Side> sides_of(const std::vector<Triangle>& triangles, std::size_t vertices,
                           const Wanted& wanted) {
  std::vector<std::uint32_t> first(vertices + 1, 0);
  auto each = [&](const auto& found) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t a = triangles[t][k], b = triangles[t][k == 2 ? 0 : k + 1];
        if (wanted(a, b)) found(Side{key_of(a, b), t, k}, std::min(a, b));
      }
  };
  each([&](const Side&, std::uint32_t low) { ++first[low + 1]; });
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<Side> sides(first.back());
  std::vector<std::uint32_t> end(first.begin(), first.end() - 1);
  each([&](const Side& side, std::uint32_t low) {
    std::uint32_t i = end[low]++;
    for (; i > first[low] && sides[i - 1].key > side.key; --i) sides[i] = sides[i - 1];
    sides[i] = side;
  });
  return sides;
}

float length2(const Vec3& v) { return glm::dot(v, v); }

}  // namespace

void SkinMesh::start(Vec3 middle, float radius, float edge) {
  constexpr float kSide = 1.05f;     // of the radius: the edge of an icosahedron
  constexpr float kLongest = 1.34f;  // of `edge`: longer sides are halved, about as in remesh()
  const float g = 1.6180340f;        // the golden ratio
  position = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  triangle = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  parents.assign(position.size(), {kNone, kNone});
  for (float side = kSide * radius; side > kLongest * edge; side /= 2) {
    for (Vec3& p : position) p = glm::normalize(p);
    split(0);
  }
  for (Vec3& p : position) p = middle + radius * glm::normalize(p);
  set_normals();
}

void SkinMesh::set_normals() {
  normal.assign(position.size(), Vec3(0));
  for (auto [a, b, c] : triangle) {
    Vec3 area = glm::cross(position[b] - position[a], position[c] - position[a]);
    normal[a] += area, normal[b] += area, normal[c] += area;
  }
  for (Vec3& n : normal) n = length2(n) > 0 ? glm::normalize(n) : Vec3(0, 1, 0);
}

/// Every triangle is cut by what it has of edges that are too long, so that the order makes no difference.
void SkinMesh::split(float longest) {
  std::vector<Side> sides = sides_of(triangle, position.size(), [&](std::uint32_t a, std::uint32_t b) {
    return length2(position[a] - position[b]) > longest * longest;
  });
  if (sides.empty()) return;
  std::vector<std::array<std::uint32_t, 3>> middle(triangle.size(), {kNone, kNone, kNone});
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].key == sides[i].key) ++end;
    auto a = static_cast<std::uint32_t>(sides[i].key >> 32), b = static_cast<std::uint32_t>(sides[i].key);
    auto added = static_cast<std::uint32_t>(position.size());
    position.push_back((position[a] + position[b]) * 0.5f);
    parents.push_back({a, b});
    for (; i < end; ++i) middle[sides[i].triangle][sides[i].k] = added;
  }
  std::size_t count = triangle.size();
  for (std::size_t t = 0; t < count; ++t) {
    auto [a, b, c] = triangle[t];
    auto [ab, bc, ca] = middle[t];
    int cuts = (ab != kNone) + (bc != kNone) + (ca != kNone);
    if (cuts == 0) continue;
    // Turned so that a single cut is the first side, and two cuts are the first two.
    while (!(cuts == 3 || (cuts == 1 && ab != kNone) || (cuts == 2 && ca == kNone))) {
      std::tie(a, b, c) = std::tuple(b, c, a);
      std::tie(ab, bc, ca) = std::tuple(bc, ca, ab);
    }
    if (cuts == 1) {
      triangle[t] = {a, ab, c};
      triangle.push_back({ab, b, c});
    } else if (cuts == 2) {
      triangle[t] = {ab, b, bc};
      if (length2(position[a] - position[bc]) < length2(position[ab] - position[c])) {
        triangle.push_back({a, ab, bc});
        triangle.push_back({a, bc, c});
      } else {
        triangle.push_back({a, ab, c});
        triangle.push_back({ab, bc, c});
      }
    } else {
      triangle[t] = {ab, bc, ca};
      triangle.push_back({a, ab, ca});
      triangle.push_back({ab, b, bc});
      triangle.push_back({ca, bc, c});
    }
  }
}

/// Turns edges across from which the two angles together are more than 180 degrees (Delaunay).
void SkinMesh::flip() {
  std::vector<Side> sides =
      sides_of(triangle, position.size(), [](std::uint32_t, std::uint32_t) { return true; });
  constexpr float kClearly = -0.2f;  // sum of cotangents: 0 at 180 degrees
  constexpr float kRidge = 0.5f;     // cosine, of 60 degrees
  std::vector<char> touched(position.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].key != sides[i + 1].key) continue;
    const Side &one = sides[i], &two = sides[++i];
    std::uint32_t a = triangle[one.triangle][one.k], b = triangle[one.triangle][(one.k + 1) % 3],
                  c = triangle[one.triangle][(one.k + 2) % 3], d = triangle[two.triangle][(two.k + 2) % 3];
    if (touched[a] || touched[b] || touched[c] || touched[d]) continue;
    if (c == d || triangle[two.triangle][two.k] != b) continue;
    Vec3 ca = position[a] - position[c], cb = position[b] - position[c], da = position[a] - position[d],
         db = position[b] - position[d];
    auto cotangent = [](Vec3 u, Vec3 v) {
      return glm::dot(u, v) / std::max(glm::length(glm::cross(u, v)), 1e-20f);
    };
    if (cotangent(ca, cb) + cotangent(da, db) > kClearly) continue;
    // Not over a ridge, and not where that edge is there already.
    Vec3 n1 = glm::cross(cb, ca), n2 = glm::cross(da, db);
    if (glm::dot(n1, n2) < kRidge * glm::length(n1) * glm::length(n2)) continue;
    std::uint64_t key = key_of(c, d);
    auto known = std::ranges::lower_bound(sides, key, {}, &Side::key);
    if (known != sides.end() && known->key == key) continue;
    triangle[one.triangle] = {c, a, d};
    triangle[two.triangle] = {d, b, c};
    touched[a] = touched[b] = touched[c] = touched[d] = 1;
  }
}

/// Draws the ends of short edges together, where the mesh stays one without folds (link condition).
bool SkinMesh::folds(const Triangle& t, std::uint32_t from, std::uint32_t to) const {
  if (std::ranges::find(t, to) != t.end()) return false;  // it goes
  Triangle moved = t;
  std::ranges::replace(moved, from, to);
  auto area = [&](const Triangle& x) {
    return glm::cross(position[x[1]] - position[x[0]], position[x[2]] - position[x[0]]);
  };
  constexpr float kTurned = 0.2f;  // cosine, of 78 degrees, by which a triangle may turn
  Vec3 before = area(t), after = area(moved);
  return glm::dot(before, after) <= kTurned * glm::length(before) * glm::length(after);
}

void SkinMesh::collapse(float shortest) {
  std::vector<Side> sides = sides_of(triangle, position.size(), [&](std::uint32_t a, std::uint32_t b) {
    return length2(position[a] - position[b]) <= shortest * shortest;
  });
  if (sides.empty()) return;
  std::vector<std::uint32_t> first(position.size() + 1, 0), around;  // triangles round each vertex
  for (const Triangle& t : triangle)
    for (std::uint32_t v : t) ++first[v + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  around.resize(3 * triangle.size());
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::uint32_t t = 0; t < triangle.size(); ++t)
    for (std::uint32_t v : triangle[t]) around[fill[v]++] = t;

  std::vector<char> touched(position.size());
  std::vector<std::uint32_t> becomes(position.size());
  for (std::uint32_t v = 0; v < becomes.size(); ++v) becomes[v] = v;
  std::vector<std::uint32_t> near_a, near_b, both;
  auto ring = [&](std::uint32_t v, std::vector<std::uint32_t>& list) {
    list.clear();
    for (std::uint32_t i = first[v]; i < first[v + 1]; ++i)
      for (std::uint32_t w : triangle[around[i]])
        if (w != v) list.push_back(w);
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && sides[i].key == sides[i - 1].key) continue;
    auto a = static_cast<std::uint32_t>(sides[i].key >> 32), b = static_cast<std::uint32_t>(sides[i].key);
    ring(a, near_a), ring(b, near_b);
    both.clear();
    std::ranges::set_intersection(near_a, near_b, std::back_inserter(both));
    if (both.size() != 2 || near_a.size() < 4 || near_b.size() < 4) continue;
    auto is_touched = [&](std::uint32_t v) { return touched[v] != 0; };
    if (touched[a] || touched[b] || std::ranges::any_of(near_a, is_touched) ||
        std::ranges::any_of(near_b, is_touched))
      continue;
    // b goes to the older a; no triangle of b may turn over.
    if (std::any_of(around.begin() + first[b], around.begin() + first[b + 1],
                    [&](std::uint32_t t) { return folds(triangle[t], b, a); }))
      continue;
    becomes[b] = a;
    touched[a] = touched[b] = 1;
    for (std::uint32_t v : near_a) touched[v] = 1;
    for (std::uint32_t v : near_b) touched[v] = 1;
  }
  std::erase_if(triangle, [&](Triangle& t) {
    for (std::uint32_t& v : t) v = becomes[v];
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

void SkinMesh::remesh(float edge, bool whole) {
  split(edge * 4 / 3);
  if (whole) {
    collapse(edge / 2);
    flip();
  }
  set_normals();
}

void SkinMesh::relax(float along, float across) {
  std::vector<Vec3> middle = means_of_neighbours(triangle, position);
  for (std::size_t v = 0; v < position.size(); ++v) {
    Vec3 offset = middle[v] - position[v], out = normal[v] * glm::dot(offset, normal[v]);
    position[v] += along * (offset - out) + across * out;
  }
}

std::vector<std::uint32_t> SkinMesh::living(std::vector<std::uint32_t>& order) const {
  order.assign(position.size(), kNone);
  for (const Triangle& t : triangle)
    for (std::uint32_t v : t) order[v] = 0;
  std::vector<std::uint32_t> list;
  for (std::uint32_t v = 0; v < order.size(); ++v)
    if (order[v] == 0) order[v] = static_cast<std::uint32_t>(list.size()), list.push_back(v);
  return list;
}

}  // namespace frond
