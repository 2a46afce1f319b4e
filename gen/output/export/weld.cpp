#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "export/surfaces.h"

namespace frond {

namespace {

constexpr double kOfVoxel = 0.01, kMostOfVoxel = 0.1;
constexpr double kFiveDigits = 3e-5;  // metres: apart in files of five decimals

using Corners = std::array<std::uint32_t, 3>;

/// A closed surface while edges of it are taken away.
class Collapse {
 public:
  explicit Collapse(Surface& surface)
      : s_(surface), around_(surface.position.size()), gone_(surface.triangle.size()) {
    std::map<std::array<float, 3>, std::uint32_t> places;
    for (const Vec3& p : s_.position) {
      auto next = static_cast<std::uint32_t>(places.size());
      place_.push_back(places.try_emplace({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, next).first->second);
    }
    there_.resize(places.size());
    for (std::uint32_t place : place_) ++there_[place];
    for (std::uint32_t t = 0; t < s_.triangle.size(); ++t)
      for (std::uint32_t v : s_.triangle[t]) around_[v].push_back(t);
  }

  /// Takes away the edges that are shorter; whether there were any that may go.
  bool shorter(float least) {
    bool any = false;
    for (std::uint32_t t = 0; t < s_.triangle.size(); ++t)
      for (std::size_t k = 0; k < 3 && !gone_[t]; ++k) {
        std::uint32_t a = s_.triangle[t][k], b = s_.triangle[t][(k + 1) % 3];
        if (glm::distance(s_.position[a], s_.position[b]) >= least || !may_go(a, b)) continue;
        join(std::min(a, b), std::max(a, b));
        any = true;
      }
    return any;
  }

  /// The triangles that are left.
  void finish() {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < s_.triangle.size(); ++t)
      if (!gone_[t]) s_.triangle[kept++] = s_.triangle[t];
    s_.triangle.resize(kept);
  }

 private:
  /// The vertices that triangles join with one, or only their places.
  std::vector<std::uint32_t> neighbours(std::uint32_t v, bool places) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t t : around_[v])
      if (!gone_[t])
        for (std::uint32_t other : s_.triangle[t])
          if (other != v) found.push_back(places ? place_[other] : other);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// The link condition (Dey, Edelsbrunner, Guha and Nekhayev 1999): the surface stays one whose edges have
  /// two triangles each where both ends share no other neighbours than the two across the edge.
  /// Where parts of the surface only touch, several vertices are at one place: these stay.
  bool may_go(std::uint32_t a, std::uint32_t b) const {
    bool apart = place_[a] != place_[b];
    if (apart && (there_[place_[a]] > 1 || there_[place_[b]] > 1)) return false;
    std::vector<std::uint32_t> of_a = neighbours(a, apart), of_b = neighbours(b, apart), both;
    std::ranges::set_intersection(of_a, of_b, std::back_inserter(both));
    auto shared = std::ranges::count_if(around_[a], [&](std::uint32_t t) {
      return !gone_[t] && std::ranges::find(s_.triangle[t], b) != s_.triangle[t].end();
    });
    return shared == 2 && both.size() == 2 && of_a.size() + of_b.size() > 6;  // and no tetrahedron
  }

  void join(std::uint32_t stays, std::uint32_t goes) {
    for (std::uint32_t t : around_[goes]) {
      if (gone_[t]) continue;
      if (std::ranges::find(s_.triangle[t], stays) != s_.triangle[t].end()) {
        gone_[t] = true;
        continue;
      }
      std::ranges::replace(s_.triangle[t], goes, stays);
      around_[stays].push_back(t);
    }
    around_[goes].clear();
    --there_[place_[goes]];
  }

  Surface& s_;
  std::vector<std::vector<std::uint32_t>> around_;  // triangles, those that are gone among them
  std::vector<bool> gone_;
  std::vector<std::uint32_t> place_;  // of each vertex
  std::vector<int> there_;            // vertices at each place
};

}  // namespace

double shortest_edge(double voxel) {
  return std::min(std::max(kOfVoxel * voxel, kFiveDigits), kMostOfVoxel * voxel);
}

void join_short_edges(Surface& s, std::vector<std::int32_t>& node, double least) {
  auto limit = static_cast<float>(least);
  if (std::ranges::none_of(s.triangle, [&](const Corners& t) {
        return glm::distance(s.position[t[0]], s.position[t[1]]) < limit ||
               glm::distance(s.position[t[1]], s.position[t[2]]) < limit ||
               glm::distance(s.position[t[2]], s.position[t[0]]) < limit;
      }))
    return;
  Collapse collapse(s);
  while (collapse.shorter(limit)) {
  }
  collapse.finish();
  std::vector<std::uint32_t> index(s.position.size(), UINT32_MAX);
  for (const Corners& t : s.triangle)
    for (std::uint32_t v : t) index[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] != 0) continue;
    s.position[kept] = s.position[v], s.normal[kept] = s.normal[v], node[kept] = node[v];
    index[v] = kept++;
  }
  s.position.resize(kept), s.normal.resize(kept), node.resize(kept);
  for (Corners& t : s.triangle)
    for (std::uint32_t& v : t) v = index[v];
}

}  // namespace frond
