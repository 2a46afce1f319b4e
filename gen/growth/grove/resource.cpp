#include "grove/resource.h"

#include <algorithm>
#include <cassert>

namespace frond {

namespace {

constexpr float kLeast = 0.006f, kMost = 1.0f;  // weights of the last and the first in a priority list
constexpr float kFalling = 0.5f;                // share of the list over which the weights fall

/// What takes part in sharing along an axis.
struct Sink {
  std::uint32_t axis;
  std::uint32_t metamer;
  bool leader;
  float light, mean;
};

}  // namespace

float gather_light(Metamers& t) {
  std::size_t n = t.size();
  for (std::size_t i = 0; i < n; ++i) {
    bool lives = !t.has(i, Metamers::dead);
    t.to_leader[i] = lives && t.has(i, Metamers::leading) ? t.light[i] : 0.0f;
    t.to_side[i] = lives && t.has(i, Metamers::bud) ? t.light[i] : 0.0f;
    t.count[i] = lives ? 1.0f : 0.0f;
  }
  for (std::size_t i = n; i-- > 1;) {
    if (t.has(i, Metamers::dead)) continue;
    std::int32_t p = t.parent[i];
    assert(p >= 0 && p < static_cast<std::int32_t>(i));
    (t.has(i, Metamers::side_shoot) ? t.to_side : t.to_leader)[p] += t.to_leader[i] + t.to_side[i];
    t.count[p] += t.count[i];
  }
  return n > 0 ? t.to_leader[0] + t.to_side[0] : 0.0f;
}

double apical_control(const Species& s, double age, int order) {
  double grown = smooth_step(0.25, 1.0, age / std::max(s.maturity, 1e-6));
  double control = s.apical_control + (s.apical_control_old - s.apical_control) * grown;
  if (order > 0) control += s.branch_control;
  return std::clamp(control, 0.01, 0.99);
}

void share_by_forks(Metamers& t, const Species& s, double age, float resource) {
  assert(t.to_leader.size() == t.size() && t.to_side.size() == t.size() && resource >= 0);
  float control[2] = {static_cast<float>(apical_control(s, age, 0)),
                      static_cast<float>(apical_control(s, age, 1))};
  for (std::size_t i = 0; i < t.size(); ++i) {
    float v = resource;
    if (i > 0) {
      std::int32_t p = t.parent[i];
      v = t.has(i, Metamers::side_shoot) ? t.to_side[p] : t.to_leader[p];
    }
    if (t.has(i, Metamers::dead)) v = 0;
    float apical = control[t.order[i] > 0];
    float leader = apical * t.to_leader[i], side = (1 - apical) * t.to_side[i], sum = leader + side;
    t.to_leader[i] = sum > 0 ? v * leader / sum : 0.0f;
    t.to_side[i] = sum > 0 ? v * side / sum : 0.0f;
  }
}

void share_by_priority(Metamers& t, const Species& s, double age, float resource) {
  assert(t.to_leader.size() == t.size() && t.count.size() == t.size() && resource >= 0);
  std::size_t n = t.size();
  std::vector<std::uint32_t> axis(n);
  std::vector<Sink> sinks;
  std::uint32_t axes = 0;
  auto mean = [&](std::size_t i) { return (t.to_leader[i] + t.to_side[i]) / std::max(t.count[i], 1.0f); };
  for (std::size_t i = 0; i < n; ++i) {
    bool begins = i == 0 || t.has(i, Metamers::side_shoot);
    axis[i] = begins ? axes++ : axis[t.parent[i]];
    if (t.has(i, Metamers::dead)) continue;
    auto index = static_cast<std::uint32_t>(i);
    if (t.has(i, Metamers::leading)) sinks.push_back({axis[i], index, true, t.light[i], t.light[i]});
    if (t.has(i, Metamers::bud)) sinks.push_back({axis[i], index, false, t.light[i], t.light[i]});
    if (begins && i > 0) {
      auto p = static_cast<std::uint32_t>(t.parent[i]);
      sinks.push_back({axis[p], p, false, t.to_side[p], mean(i)});
    }
  }
  // The leader comes first where the tree holds it up: its light counts for more by apical control.
  for (Sink& sink : sinks) {
    double control = apical_control(s, age, t.order[sink.metamer]);
    if (sink.leader) sink.mean *= static_cast<float>(control / (1 - control));
  }
  std::stable_sort(sinks.begin(), sinks.end(), [](const Sink& a, const Sink& b) {
    return a.axis != b.axis ? a.axis < b.axis : a.mean > b.mean;
  });
  std::vector<std::uint32_t> first(axes + 1, 0);
  for (const Sink& sink : sinks) ++first[sink.axis + 1];
  for (std::uint32_t a = 0; a < axes; ++a) first[a + 1] += first[a];

  std::vector<float> side(n, 0.0f), leader(n, 0.0f);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0 && !t.has(i, Metamers::side_shoot)) continue;
    // Axes begin in the order of their metamers, so what an axis has is known before it is handed on.
    float v = i == 0 ? resource : side[t.parent[i]], sum = 0;
    std::uint32_t from = first[axis[i]], to = first[axis[i] + 1];
    assert(from <= to && to <= sinks.size());
    auto weight = [&](std::uint32_t k) {
      float along = static_cast<float>(k - from) / std::max(1.0f, kFalling * static_cast<float>(to - from));
      return std::max(kLeast, kMost + (kLeast - kMost) * along);
    };
    for (std::uint32_t k = from; k < to; ++k) sum += sinks[k].light * weight(k);
    for (std::uint32_t k = from; k < to && sum > 0; ++k)
      (sinks[k].leader ? leader : side)[sinks[k].metamer] += v * sinks[k].light * weight(k) / sum;
  }
  t.to_leader = std::move(leader);
  t.to_side = std::move(side);
}

}  // namespace frond
