#include "organisms/fan/fan.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "core/noise.h"

namespace frond {

namespace {

constexpr std::uint32_t kNoPlace = ~0u;

/// Places in a plane, each with up to six neighbours: a net of triangles, shaken.
struct FanNet {
  std::vector<Vec2> place;
  std::vector<std::array<std::uint32_t, 6>> near;
  std::uint32_t foot = 0;
};

bool is_in_outline(const FanParams& params, Vec2 p, Vec3 lot) {
  constexpr float kMiddle = 0.54f, kHalfHeight = 0.46f;  // of an ellipse, as shares of the height
  constexpr float kNarrow = 1.12f, kWidens = 0.22f;      // at the middle, and from there up
  constexpr float kBroadRough = 0.30f, kFineRough = 0.16f, kCleftDepth = 0.5f;  // for `ragged` 1
  constexpr float kCleftsMeet = 0.1f;  // of the height, below the foot
  auto half = static_cast<float>(params.across / 2), high = static_cast<float>(params.height);
  float x = p.x / half, y = (p.y - kMiddle * high) / (kHalfHeight * high);
  // Wider above than below, as a fan.
  x *= kNarrow - kWidens * y;
  Vec3 sample(4 * x, 4 * y, 0);
  float rough =
      static_cast<float>(params.ragged) * (kBroadRough * static_cast<float>(noise(sample * 0.35f + lot)) +
                                           kFineRough * static_cast<float>(noise(sample + lot)));
  // Clefts run toward the foot.
  float angle = std::atan2(p.x, p.y + kCleftsMeet * high);
  float cleft = static_cast<float>(noise(Vec3(7 * angle, 0.6f * y, 3) + lot));
  rough -= static_cast<float>(params.ragged) * kCleftDepth * smooth_step(0.45f, 0.8f, cleft) *
           smooth_step(0.2f, 0.9f, y);
  return x * x + y * y < (1 + rough) * (1 + rough);
}

FanNet weave(const FanParams& params, Seed seed) {
  constexpr float kRowHeight = 0.866f;                          // of triangles with sides of 1
  constexpr double kOutlineWidth = 0.75, kOutlineHeight = 1.2;  // woven to each side, and upward
  constexpr double kShake = 0.42;                               // of the mesh
  FanNet net;
  auto mesh = static_cast<float>(params.mesh), step = mesh * kRowHeight;
  Vec3 lot(seed.child("outline").range(-99, 99), 0, 0);
  int wide = static_cast<int>(kOutlineWidth * params.across / params.mesh) + 2;
  int rows = static_cast<int>(kOutlineHeight * params.height / step) + 2, count = 2 * wide + 1;
  std::vector<std::uint32_t> number(static_cast<std::size_t>(rows * count), kNoPlace);
  Seed shake = seed.child("shake");
  float best = 1e9f;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < count; ++i) {
      Vec2 p((static_cast<float>(i - wide) + 0.5f * static_cast<float>(j % 2)) * mesh,
             static_cast<float>(j) * step);
      if (!is_in_outline(params, p, lot)) continue;
      Seed own = shake.child(static_cast<std::uint64_t>(j * count + i));
      p += Vec2(own.child(0).range(-kShake, kShake), own.child(1).range(-kShake, kShake)) * mesh;
      if (float d = glm::length(p); d < best)
        best = d, net.foot = static_cast<std::uint32_t>(net.place.size());
      number[static_cast<std::size_t>(j * count + i)] = static_cast<std::uint32_t>(net.place.size());
      net.place.push_back(p);
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < count; ++i) {
      if (number[static_cast<std::size_t>(j * count + i)] == kNoPlace) continue;
      auto at = [&](int y, int x) {
        return y < 0 || y >= rows || x < 0 || x >= count ? kNoPlace
                                                         : number[static_cast<std::size_t>(y * count + x)];
      };
      int low = j % 2 - 1;  // what lies aside in the rows above and below
      net.near.push_back({at(j, i - 1), at(j, i + 1), at(j - 1, i + low), at(j - 1, i + low + 1),
                          at(j + 1, i + low), at(j + 1, i + low + 1)});
    }
  return net;
}

/// The shortest paths to the foot, with random edge weights (Dijkstra 1959).
struct FanPaths {
  std::vector<float> distance;
  std::vector<std::uint32_t> below, order;  // nearer ones first
};

FanPaths find_paths(const FanNet& net, Seed seed) {
  constexpr double kShortest = 0.8, kLongest = 1.3;  // weights of edges, in their lengths
  FanPaths paths{
      std::vector<float>(net.place.size(), 1e9f), std::vector<std::uint32_t>(net.place.size(), kNoPlace), {}};
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  paths.distance[net.foot] = 0;
  open.push({0, net.foot});
  while (!open.empty()) {
    auto [far, v] = open.top();
    open.pop();
    if (far > paths.distance[v]) continue;
    paths.order.push_back(v);
    for (std::uint32_t w : net.near[v]) {
      if (w == kNoPlace) continue;
      std::uint64_t edge = static_cast<std::uint64_t>(std::min(v, w)) << 32 | std::max(v, w);
      float length = glm::distance(net.place[v], net.place[w]);
      float to = far + length * static_cast<float>(seed.child(edge).range(kShortest, kLongest));
      if (to < paths.distance[w]) paths.distance[w] = to, paths.below[w] = v, open.push({to, w});
    }
  }
  return paths;
}

/// Threads are smoother than the net that they run in.
void straighten(FanNet& net, const FanPaths& paths, const std::vector<std::uint32_t>& next) {
  for (int round = 0; round < 3; ++round) {
    std::vector<Vec2> last = net.place;
    for (std::uint32_t v : paths.order)
      if (paths.below[v] != kNoPlace && next[v] != kNoPlace)
        net.place[v] = 0.5f * last[v] + 0.25f * (last[paths.below[v]] + last[next[v]]);
  }
}

/// What flows through each thread, and which it comes from mainly.
struct FanFlow {
  std::vector<float> load;
  std::vector<std::uint32_t> next;
};

FanFlow flow_of(const FanPaths& paths, std::size_t count) {
  FanFlow flow{std::vector<float>(count, 1), std::vector<std::uint32_t>(count, kNoPlace)};
  for (std::size_t k = paths.order.size(); k-- > 1;) {
    std::uint32_t v = paths.order[k], b = paths.below[v];
    flow.load[b] += flow.load[v];
    if (flow.next[b] == kNoPlace || flow.load[v] > flow.load[flow.next[b]]) flow.next[b] = v;
  }
  return flow;
}

/// Threads that meet side by side grow together.
template <class Place>
void link_threads(Skeleton& s, const FanNet& net, const FanPaths& paths,
                  const std::vector<std::int32_t>& node, const Place& place, const FanParams& params,
                  Seed links) {
  constexpr float kSideBySide = 0.75f;  // of the mesh: how much farther from the foot one may be
  for (std::uint32_t v : paths.order)
    for (std::uint32_t w : net.near[v]) {
      if (w == kNoPlace || paths.below[w] == v || paths.below[v] == w ||
          paths.distance[w] < paths.distance[v])
        continue;
      if (w == v || paths.distance[w] - paths.distance[v] > kSideBySide * static_cast<float>(params.mesh))
        continue;
      std::uint64_t edge = static_cast<std::uint64_t>(std::min(v, w)) << 32 | std::max(v, w);
      if (links.child(edge).unit() >= params.links) continue;
      auto depth = static_cast<std::uint16_t>(s.order[static_cast<std::size_t>(node[v])] + 1);
      s.add(place(w), static_cast<float>(params.thread), node[v], depth);
    }
}

}  // namespace

Skeleton grow_fan(const FanParams& params, Seed seed) {
  // How it bends out of its plane: amplitudes at the top as shares of `curl`, and waves on its height.
  constexpr float kBroadCurl = 1.5f, kBroadWaves = 1.3f, kFineCurl = 0.12f, kFineWaves = 9;
  constexpr float kHold = 0.02f, kHoldRadius = 1.5f;  // metres below the ground; in radii of the foot
  FanNet net = weave(params, seed.child("net"));
  FanPaths paths = find_paths(net, seed.child("ways"));
  std::size_t count = net.place.size();
  const auto [load, next] = flow_of(paths, count);
  straighten(net, paths, next);
  float most = load[net.foot];
  auto thin = static_cast<float>(params.thread), foot = static_cast<float>(params.foot);
  auto radius_of = [&](float flow) {
    return std::max(thin, foot * std::pow(flow / most, static_cast<float>(1 / params.gather)));
  };
  Vec3 lot(seed.child("curl").range(-99, 99), 0, 0);
  auto high = static_cast<float>(params.height);
  auto place = [&](std::uint32_t v) {
    Vec2 p = net.place[v];
    Vec3 at(p.x, p.y, 0);
    float out = static_cast<float>(params.curl) * p.y / high;
    at.z = out * kBroadCurl * static_cast<float>(noise(at * (kBroadWaves / high) + lot)) +
           kFineCurl * out * static_cast<float>(noise(at * (kFineWaves / high) + lot));
    return at;
  };
  Skeleton s;
  s.reserve(3 * count);
  std::int32_t root = s.add(Vec3(0, -kHold, 0), kHoldRadius * foot, Skeleton::kRoot, 0);
  std::vector<std::int32_t> node(count, Skeleton::kRoot);
  std::vector<std::vector<std::uint32_t>> sides(count);
  for (std::uint32_t v : paths.order)
    if (paths.below[v] != kNoPlace && next[paths.below[v]] != v) sides[paths.below[v]].push_back(v);
  struct Task {
    std::uint32_t place;
    std::int32_t below;
    std::uint16_t depth;
  };
  std::vector<Task> open{{net.foot, root, 0}};
  std::vector<std::uint32_t> thread;
  while (!open.empty()) {
    Task task = open.back();
    open.pop_back();
    std::int32_t below = task.below;
    thread.clear();
    for (std::uint32_t v = task.place; v != kNoPlace; v = next[v]) {
      below = node[v] = s.add(place(v), radius_of(load[v]), below, task.depth);
      thread.push_back(v);
    }
    for (std::uint32_t v : thread)
      for (std::uint32_t w : sides[v])
        open.push_back({w, node[v], static_cast<std::uint16_t>(task.depth + 1)});
  }
  link_threads(s, net, paths, node, place, params, seed.child("links"));
  set_tip_distances(s);
  set_births(s);
  return s;
}

}  // namespace frond
