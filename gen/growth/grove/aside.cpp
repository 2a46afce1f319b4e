#include "grove/aside.h"

#include <cassert>

#include "grove/wood.h"

namespace frond {

void bend_aside(Metamers& t, const Wood& wood, const Detour& detour, std::size_t first) {
  constexpr float kMostTurned =
      0.5f;  // cosine of the angle by which a branch's new shoot bends aside at most
  assert(first <= t.size());
  std::vector<Vec3> shift(t.size(), Vec3(0));
  std::vector<std::uint8_t> stay(t.size(), 1);
  bool all = true;
  for (std::size_t i = 1; i < t.size(); ++i) {
    auto p = static_cast<std::size_t>(t.parent[i]);
    Vec3 from = t.tip[p], to = t.tip[i] + shift[p];
    std::optional<Vec3> way;
    if (stay[p]) way = detour(from, to, pipe_radius(wood, t.pipe[i]) + kBarkGap);
    bool turned =
        way && t.order[i] > 0 &&
        glm::dot(*way - from, to - from) < kMostTurned * glm::length(*way - from) * glm::length(to - from);
    if (i >= first && (!way || turned)) {
      stay[i] = 0;
      all = false;
      continue;
    }
    to = way.value_or(to);
    shift[i] = to - t.tip[i];
    t.tip[i] = to;
  }
  if (!all) t.keep(stay);
}

}  // namespace frond
