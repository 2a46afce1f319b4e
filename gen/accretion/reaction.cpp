#include "accretion/reaction.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::size_t kReactionBatch = 4096;  // vertices that one thread takes
constexpr double kMostSpread = 0.42;
constexpr double kWaveOfSpread =
    21.0;  // about: length of a wave by the root of what the second substance spreads

/// The neighbours of each vertex, one list after the other.
struct Rings {
  std::vector<std::uint32_t> first, next;
};

Rings rings_of(const Surface& surface) {
  Rings rings;
  rings.first.assign(surface.position.size() + 1, 0);
  // In a closed mesh each neighbour is that of one side.
  for (const auto& t : surface.triangle)
    for (std::uint32_t v : t) ++rings.first[v + 1];
  for (std::size_t v = 1; v < rings.first.size(); ++v) rings.first[v] += rings.first[v - 1];
  rings.next.resize(rings.first.back());
  std::vector<std::uint32_t> fill(rings.first.begin(), rings.first.end() - 1);
  for (const auto& t : surface.triangle)
    for (std::size_t k = 0; k < 3; ++k) rings.next[fill[t[k]]++] = t[(k + 1) % 3];
  return rings;
}

/// The mean length of edges.
double edge_of(const Surface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangle)
    sum += glm::distance(surface.position[a], surface.position[b]);
  return surface.triangle.empty() ? 1 : sum / static_cast<double>(surface.triangle.size());
}

}  // namespace

std::vector<float> react(const Surface& surface, const Reaction& reaction, Seed seed) {
  std::size_t count = surface.position.size();
  Rings rings = rings_of(surface);
  // Spread in edges squared; a mean over neighbours spreads by a quarter of their distance squared, twice.
  double wave = reaction.wave / edge_of(surface);
  double second = wave * wave / (kWaveOfSpread * kWaveOfSpread) * 4;
  // What would spread too fast to be reckoned step by step reacts more slowly instead, in more steps.
  double slower = std::max(1.0, second / kMostSpread);
  second /= slower;
  auto pace = static_cast<float>(1 / slower);
  auto steps = static_cast<int>(reaction.steps * slower);
  auto spread_a = static_cast<float>(2 * second), spread_b = static_cast<float>(second);
  auto feed = static_cast<float>(reaction.feed), kill = static_cast<float>(reaction.kill);
  std::vector<float> a(count), b(count), next_a(count), next_b(count);
  auto frequency = static_cast<float>(1.6 / reaction.wave);
  Vec3 shift(static_cast<float>(seed.child("x").range(-99, 99)),
             static_cast<float>(seed.child("y").range(-99, 99)), 0);
  for (std::size_t v = 0; v < count; ++v) {
    bool drop = reaction.fine ? seed.child(v / 7).unit() < 0.16
                              : noise(surface.position[v] * frequency + shift) > 0.25;
    a[v] = drop ? 0.5f : 1.0f;
    b[v] = drop ? 0.25f + 0.1f * static_cast<float>(seed.child("b", v).unit()) : 0.0f;
  }
  std::size_t batches = (count + kReactionBatch - 1) / kReactionBatch;
  for (int step = 0; step < steps; ++step) {
    parallel_for(batches, [&](std::size_t batch) {
      for (std::size_t v = batch * kReactionBatch; v < std::min(count, (batch + 1) * kReactionBatch); ++v) {
        float sum_a = 0, sum_b = 0;
        std::uint32_t from = rings.first[v], to = rings.first[v + 1];
        for (std::uint32_t i = from; i < to; ++i) sum_a += a[rings.next[i]], sum_b += b[rings.next[i]];
        float share = to > from ? 1.0f / static_cast<float>(to - from) : 0.0f;
        float turned = a[v] * b[v] * b[v];
        next_a[v] = a[v] + spread_a * (sum_a * share - a[v]) + pace * (feed * (1 - a[v]) - turned);
        next_b[v] = b[v] + spread_b * (sum_b * share - b[v]) + pace * (turned - (kill + feed) * b[v]);
      }
    });
    std::swap(a, next_a), std::swap(b, next_b);
  }
  float most = 1e-6f;
  for (float x : b) most = std::max(most, x);
  for (float& x : b) x = std::clamp(x / most, 0.0f, 1.0f);
  return b;
}

}  // namespace frond
