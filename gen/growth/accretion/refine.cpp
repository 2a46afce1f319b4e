#include "accretion/refine.h"

#include <algorithm>

#include "accretion/skin_mesh.h"

namespace frond {

namespace {

struct Cut {
  std::uint64_t key;
  std::uint32_t triangle, side;
};

/// The ends of each new vertex, in the order of their keys; `middle` has that of each side of each triangle.
std::vector<std::array<std::uint32_t, 2>> cut_edges(const Surface& s,
                                                    std::vector<std::array<std::uint32_t, 3>>& middle) {
  std::vector<Cut> cuts;
  for (std::uint32_t t = 0; t < s.triangle.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint64_t a = s.triangle[t][k], b = s.triangle[t][(k + 1) % 3];
      cuts.push_back({std::min(a, b) << 32 | std::max(a, b), t, k});
    }
  std::ranges::sort(cuts, {}, &Cut::key);
  std::vector<std::array<std::uint32_t, 2>> ends;
  middle.resize(s.triangle.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (i == 0 || cuts[i].key != cuts[i - 1].key)
      ends.push_back(
          {static_cast<std::uint32_t>(cuts[i].key >> 32), static_cast<std::uint32_t>(cuts[i].key)});
    middle[cuts[i].triangle][cuts[i].side] = static_cast<std::uint32_t>(s.position.size() + ends.size() - 1);
  }
  return ends;
}

void round_off(std::vector<Vec3>& places, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Vec3> middle = means_of_neighbours(triangles, places);
  for (std::size_t v = 0; v < places.size(); ++v) places[v] = glm::mix(places[v], middle[v], 0.45f);
}

}  // namespace

void refine(Accreted& skin, int times) {
  for (; times > 0; --times) {
    Surface& s = skin.surface;
    std::vector<std::array<std::uint32_t, 3>> middle;
    auto ends = cut_edges(s, middle);
    auto add_means = [&](auto& list) {
      list.reserve(list.size() + ends.size());
      for (auto [a, b] : ends) list.push_back((list[a] + list[b]) * 0.5f);
    };
    add_means(s.position), add_means(skin.birth), add_means(skin.shade);
    for (std::vector<Vec3>& places : skin.past) add_means(places);
    std::vector<std::array<std::uint32_t, 3>> cut;
    cut.reserve(4 * s.triangle.size());
    for (std::size_t t = 0; t < s.triangle.size(); ++t) {
      auto [a, b, c] = s.triangle[t];
      auto [ab, bc, ca] = middle[t];
      cut.insert(cut.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s.triangle = std::move(cut);
    round_off(s.position, s.triangle);
    for (std::vector<Vec3>& places : skin.past) round_off(places, s.triangle);
  }
  set_normals(skin.surface);
}

void raise(Accreted& skin, const std::vector<float>& height) {
  Surface& s = skin.surface;
  Surface before{.position = {}, .normal = s.normal, .triangle = s.triangle, .uv = {}};
  for (std::size_t step = 0; step < skin.past.size(); ++step) {
    before.position = skin.past[step];
    set_normals(before);
    float share = static_cast<float>(step) / static_cast<float>(skin.past.size());
    for (std::size_t v = 0; v < height.size(); ++v)
      skin.past[step][v] += before.normal[v] * (height[v] * share);
  }
  for (std::size_t v = 0; v < height.size(); ++v) s.position[v] += s.normal[v] * height[v];
  set_normals(s);
}

}  // namespace frond
