#include "accretion/reaction.h"

#include <algorithm>
#include <array>

#include "core/bounds.h"
#include "core/noise.h"
#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::size_t kReactionBatch = 4096;           // vertices that one thread takes
constexpr std::size_t kReactionBlock = 64;             // and those that stay in the nearest cache
constexpr double kMostSpread = 0.42, kMostPace = 1.5;  // of a step, so that it does not swing
constexpr double kWaveOfSpread = 21.0;  // about: a wave's length by the root of the second substance's spread

/// Vertices in an order in which those that are near in space are near in memory (Morton 1966).
std::vector<std::uint32_t> near_order(const std::vector<Vec3>& places) {
  Bounds box = bounds_of(places);
  float cells = 1023 / std::max(box.longest(), 1e-20f);
  std::vector<std::uint64_t> keys;
  for (std::uint32_t v = 0; v < places.size(); ++v) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      auto cell = static_cast<std::uint64_t>((places[v][axis] - box.low[axis]) * cells);
      for (int bit = 0; bit < 10; ++bit) key |= (cell >> bit & 1) << (3 * bit + axis);
    }
    keys.push_back(key << 32 | v);
  }
  std::ranges::sort(keys);
  std::vector<std::uint32_t> order;
  for (std::uint64_t key : keys) order.push_back(static_cast<std::uint32_t>(key));
  return order;
}

/// The neighbours of each vertex, one list after the other; vertices by their place in an order.
struct Rings {
  std::vector<std::uint32_t> first, next;
};

Rings rings_of(const Surface& surface, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  Rings rings;
  rings.first.assign(order.size() + 1, 0);
  // In a closed mesh each neighbour is that of one side.
  for (const auto& t : surface.triangle)
    for (std::uint32_t v : t) ++rings.first[place[v] + 1];
  for (std::size_t v = 1; v < rings.first.size(); ++v) rings.first[v] += rings.first[v - 1];
  rings.next.resize(rings.first.back());
  std::vector<std::uint32_t> fill(rings.first.begin(), rings.first.end() - 1);
  for (const auto& t : surface.triangle)
    for (std::size_t k = 0; k < 3; ++k) rings.next[fill[place[t[k]]]++] = place[t[(k + 1) % 3]];
  return rings;
}

/// The mean length of edges.
double edge_of(const Surface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangle)
    sum += glm::distance(surface.position[a], surface.position[b]);
  return surface.triangle.empty() ? 1 : sum / static_cast<double>(surface.triangle.size());
}

/// How fast both substances spread and turn into each other, in a step.
struct Rates {
  float spread_a, spread_b, pace, feed, kill;
};

/// One step of the vertices from `begin` to `end`, at most a block: sums first, which jump about in memory,
/// then what can be reckoned for several at once.
void step_block(const Rings& rings, const Rates& rates, const Vec2* now, Vec2* next, std::size_t begin,
                std::size_t end) {
  std::array<float, kReactionBlock> mean_a, mean_b, own_a, own_b;
  const std::uint32_t* ring = rings.next.data();
  for (std::size_t v = begin; v < end; ++v) {
    std::uint32_t from = rings.first[v], to = rings.first[v + 1];
    Vec2 sum(0);
    if (to - from == 6) {
      // Nearly all, once triangles have been cut.
      const std::uint32_t* r = ring + from;
      sum = ((now[r[0]] + now[r[1]]) + (now[r[2]] + now[r[3]]) + (now[r[4]] + now[r[5]])) * (1.0f / 6);
    } else {
      for (std::uint32_t i = from; i < to; ++i) sum += now[ring[i]];
      sum *= to > from ? 1.0f / static_cast<float>(to - from) : 0.0f;
    }
    mean_a[v - begin] = sum.x, mean_b[v - begin] = sum.y;
    own_a[v - begin] = now[v].x, own_b[v - begin] = now[v].y;
  }
  for (std::size_t i = 0; i < end - begin; ++i) {
    float a = own_a[i], b = own_b[i], turned = a * b * b;
    next[begin + i] = {
        a + rates.spread_a * (mean_a[i] - a) + rates.pace * (rates.feed * (1 - a) - turned),
        b + rates.spread_b * (mean_b[i] - b) + rates.pace * (turned - (rates.kill + rates.feed) * b)};
  }
}

}  // namespace

std::vector<float> react(const Surface& surface, const Reaction& reaction, Seed seed) {
  std::size_t count = surface.position.size();
  std::vector<std::uint32_t> order = near_order(surface.position);
  Rings rings = rings_of(surface, order);
  // Spread in edges squared; a mean over neighbours spreads by a quarter of their distance squared, twice.
  double wave = reaction.wave / edge_of(surface);
  double second = wave * wave / (kWaveOfSpread * kWaveOfSpread) * 4;
  // Steps as long as they may be: what spreads fast takes short ones.
  double pace = std::min(kMostPace, kMostSpread / second);
  auto steps = static_cast<int>(reaction.steps / pace);
  Rates rates{static_cast<float>(2 * second * pace), static_cast<float>(second * pace),
              static_cast<float>(pace), static_cast<float>(reaction.feed), static_cast<float>(reaction.kill)};
  // Drops of the second substance, by which the pattern begins: some of the vertices, or spots of noise.
  constexpr std::uint32_t kTogether = 7;  // vertices that are alike
  constexpr double kDrops = 0.16;         // share of vertices
  constexpr double kSpot = 0.25;          // value of the noise, above which there is a spot
  constexpr double kSpots = 1.6;          // units of the noise from wave to wave
  auto frequency = static_cast<float>(kSpots / reaction.wave);
  Vec3 shift(seed.child("x").range(-99, 99), seed.child("y").range(-99, 99), 0);
  std::vector<Vec2> now(count), next(count);  // both substances
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t v = order[i];
    bool drop = reaction.fine ? seed.child(v / kTogether).unit() < kDrops
                              : noise(surface.position[v] * frequency + shift) > kSpot;
    now[i] = {drop ? 0.5f : 1.0f, drop ? 0.25f + 0.1f * static_cast<float>(seed.child("b", v).unit()) : 0.0f};
  }
  std::size_t batches = (count + kReactionBatch - 1) / kReactionBatch;
  for (int step = 0; step < steps; ++step) {
    parallel_for(batches, [&](std::size_t batch) {
      std::size_t last = std::min(count, (batch + 1) * kReactionBatch);
      for (std::size_t v = batch * kReactionBatch; v < last; v += kReactionBlock)
        step_block(rings, rates, now.data(), next.data(), v, std::min(last, v + kReactionBlock));
    });
    std::swap(now, next);
  }
  float most = 1e-6f;
  for (Vec2 x : now) most = std::max(most, x.y);
  std::vector<float> tone(count);
  for (std::size_t i = 0; i < count; ++i) tone[order[i]] = std::clamp(now[i].y / most, 0.0f, 1.0f);
  return tone;
}

}  // namespace frond
