#include "images/vein_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frond {

namespace {

constexpr float kGridCell = 0.03f;  // side of a cell of the grid, of a blade that is not wider than long
constexpr float kRim = 0.03f;       // share of the way from the middle that sources keep off the rim
constexpr float kVeinRim = 0.012f;  // that veins keep off it
constexpr int kMostSteps = 120;     // of a round
constexpr int kPatience = 3;        // steps without coming nearer, until a source is given up
constexpr double kPipe = 3;         // exponent of the pipe model

}  // namespace

VeinTree::VeinTree(const Lamina& blade)
    : blade_(blade), corner_(-blade.wide(), blade.low()), cell_(kGridCell * std::max(1.0f, blade.wide())) {
  columns_ = static_cast<int>(2 * blade.wide() / cell_) + 1;
  rows_ = static_cast<int>((blade.high() - blade.low()) / cell_) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
}

std::size_t VeinTree::cell_of(Vec2 p) const {
  int x = std::clamp(static_cast<int>((p.x - corner_.x) / cell_), 0, columns_ - 1),
      y = std::clamp(static_cast<int>((p.y - corner_.y) / cell_), 0, rows_ - 1);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
}

std::uint32_t VeinTree::add(Vec2 at, std::int32_t parent, std::uint8_t order) {
  auto index = static_cast<std::uint32_t>(veins_.size());
  veins_.point.push_back(at);
  veins_.parent.push_back(parent);
  veins_.order.push_back(order);
  std::int32_t& head = first_[cell_of(at)];
  next_.push_back(head);
  head = static_cast<std::int32_t>(index);
  return index;
}

/// Visits the points of all cells that are `ring` cells away from that of `p`.
template <class Visit>
void VeinTree::each_in_ring(Vec2 p, int ring, Visit visit) const {
  auto cell = static_cast<int>(cell_of(p));
  int cx = cell % columns_, cy = cell / columns_;
  for (int y = std::max(cy - ring, 0); y <= std::min(cy + ring, rows_ - 1); ++y) {
    bool whole = std::abs(y - cy) == ring;
    for (int x = cx - ring; x <= cx + ring; x += whole || ring == 0 ? 1 : 2 * ring) {
      if (x < 0 || x >= columns_) continue;
      for (std::int32_t i = first_[y * columns_ + x]; i >= 0; i = next_[i])
        visit(static_cast<std::uint32_t>(i));
    }
  }
}

std::optional<std::uint32_t> VeinTree::nearest(Vec2 p, float reach, std::uint32_t end) const {
  std::optional<std::uint32_t> best;
  float least = reach;
  for (int ring = 0; static_cast<float>(ring - 1) * cell_ < least; ++ring)
    each_in_ring(p, ring, [&](std::uint32_t i) {
      float d = glm::distance(veins_.point[i], p);
      // Of equally near ones the first, whatever order the cells have.
      if (i >= end || d > least || (d == least && best && i > *best)) return;
      least = d, best = i;
    });
  return best;
}

std::vector<VeinTree::Source> VeinTree::scatter(double apart, double clear, Seed seed) const {
  // Candidates on a grid with jitter, in random order: what they leave open is nowhere wide.
  const double gap = std::min(0.5 * apart, clear);
  std::vector<std::pair<std::uint64_t, Vec2>> candidates;
  std::uint64_t index = 0;
  for (double y = blade_.low(); y < blade_.high(); y += gap)
    for (double x = -blade_.wide(); x < blade_.wide(); x += gap) {
      Seed own = seed.child(index++);
      Vec2 p(static_cast<float>(x + gap * own.child(0).unit()),
             static_cast<float>(y + gap * own.child(1).unit()));
      if (blade_.holds(p, kRim)) candidates.emplace_back(own.child(2).bits(), p);
    }
  std::ranges::sort(candidates, {}, [](const auto& c) { return c.first; });
  // A grid whose cells hold few sources each.
  const auto far = static_cast<float>(apart);
  const int columns = static_cast<int>(2 * blade_.wide() / far) + 3,
            rows = static_cast<int>((blade_.high() - blade_.low()) / far) + 3;
  std::vector<std::int32_t> first(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), -1),
      next;
  std::vector<Source> sources;
  for (const auto& [key, p] : candidates) {
    if (nearest(p, static_cast<float>(clear), static_cast<std::uint32_t>(veins_.size()))) continue;
    int cx = static_cast<int>((p.x - corner_.x) / far) + 1,
        cy = static_cast<int>((p.y - corner_.y) / far) + 1;
    bool free = true;
    for (int k = 0; k < 9 && free; ++k)
      for (std::int32_t i = first[(cy + k / 3 - 1) * columns + cx + k % 3 - 1]; i >= 0 && free; i = next[i])
        free = glm::distance(sources[i].at, p) >= far;
    if (!free) continue;
    std::int32_t& head = first[cy * columns + cx];
    next.push_back(head);
    head = static_cast<std::int32_t>(sources.size());
    sources.push_back({p});
  }
  return sources;
}

/// All relative neighbours of a source lie among the nearest in six equal sectors round it; those that
/// another one is nearer to than the source are none (Toussaint 1980).
VeinTree::Attracted VeinTree::attracted(Vec2 source, bool loops) const {
  constexpr float kFarther = 2.5f;  // neighbours are no farther than that many times the nearest
  std::array<std::int32_t, 6> node;
  std::array<float, 6> distance;
  node.fill(-1), distance.fill(1e9f);
  float least = 1e9f;
  const int most = std::max(columns_, rows_);
  for (int ring = 0; ring <= most && static_cast<float>(ring - 1) * cell_ < kFarther * least; ++ring)
    each_in_ring(source, ring, [&](std::uint32_t i) {
      Vec2 off = veins_.point[i] - source;
      float d = glm::length(off);
      // Which half, and in it which third, without an angle.
      float side = 0.57735f * std::abs(off.y);
      std::size_t sector = (off.x > side ? 0u : off.x < -side ? 2u : 1u) + (off.y < 0 ? 3u : 0u);
      if (d > distance[sector] || (d == distance[sector] && static_cast<std::int32_t>(i) > node[sector]))
        return;
      node[sector] = static_cast<std::int32_t>(i), distance[sector] = d, least = std::min(least, d);
    });
  std::array<std::size_t, 6> by{0, 1, 2, 3, 4, 5};
  std::ranges::sort(by, {}, [&](std::size_t k) { return distance[k]; });
  Attracted found{};
  for (std::size_t k : by) {
    if (node[k] < 0 || distance[k] > kFarther * least) break;
    Vec2 at = veins_.point[node[k]];
    bool neighbour = blade_.holds_way(source, at);
    for (int i = 0; i < found.count && neighbour; ++i)
      neighbour = glm::distance(veins_.point[found.node[i]], at) >= distance[k];
    if (!neighbour) continue;
    found.node[found.count] = static_cast<std::uint32_t>(node[k]);
    found.distance[found.count++] = distance[k];
    if (!loops) break;
  }
  return found;
}

/// The veins that have come to a source meet in it.
void VeinTree::arrive(Vec2 source, const Attracted& veins, float kill, std::uint8_t order) {
  int near = 0;
  while (near < veins.count && veins.distance[near] <= kill) ++near;
  if (near < 2) return;
  std::uint32_t meeting = add(source, static_cast<std::int32_t>(veins.node[0]), order);
  for (int i = 1; i < near; ++i) join(meeting, veins.node[i]);
}

/// Adds a point to each vein that is pulled. Whether one was added.
bool VeinTree::grow_step(float step, std::uint8_t order, Seed seed) {
  constexpr float kStray = 0.25f;
  bool any = false;
  for (std::uint32_t i : pulled_) {
    Vec2 pull = pull_[i];
    pull_[i] = Vec2(0);
    float length = glm::length(pull);
    if (length < 1e-3f) continue;
    Seed own = seed.child(i);
    Vec2 stray(static_cast<float>(own.child(0).range(-kStray, kStray)),
               static_cast<float>(own.child(1).range(-kStray, kStray)));
    Vec2 at = veins_.point[i] + step * glm::normalize(pull / length + stray);
    if (!blade_.holds(at, kVeinRim)) continue;
    if (nearest(at, 0.45f * step, static_cast<std::uint32_t>(veins_.size()))) continue;
    add(at, static_cast<std::int32_t>(i), order);
    any = true;
  }
  pulled_.clear();
  return any;
}

void VeinTree::colonize(double apart, double clear, std::uint8_t order, bool loops, Seed seed) {
  const auto step = static_cast<float>(std::clamp(0.44 * clear, 0.004, 0.02)), kill = 1.2f * step;
  std::vector<Source> sources = scatter(apart, clear, seed.child("sources"));
  for (int round = 0; round < kMostSteps && !sources.empty(); ++round) {
    pull_.resize(veins_.size(), Vec2(0));
    std::size_t kept = 0;
    const std::size_t all = sources.size();
    for (std::size_t s = 0; s < all; ++s) {
      Source source = sources[s];
      Attracted veins = attracted(source.at, loops);
      float sum = 0;
      int coming = 0;
      for (int k = 0; k < veins.count; ++k) sum += veins.distance[k], coming += veins.distance[k] > kill;
      bool nearer = sum < source.ways - 0.1f * step;
      source.waited = nearer ? 0 : source.waited + 1;
      if (nearer || veins.count != source.count) source.ways = sum, source.count = veins.count;
      if (coming == 0 || source.waited > kPatience) {
        arrive(source.at, veins, kill, order);
        pull_.resize(veins_.size(), Vec2(0));
        continue;
      }
      for (int k = 0; k < veins.count; ++k) {
        if (veins.distance[k] <= kill) continue;
        std::uint32_t i = veins.node[k];
        if (pull_[i] == Vec2(0)) pulled_.push_back(i);
        pull_[i] += (source.at - veins_.point[i]) / veins.distance[k];
      }
      sources[kept++] = source;
    }
    sources.resize(kept);
    grow_step(step, order, seed.child("step", static_cast<std::uint64_t>(round)));
  }
}

Veins VeinTree::take(double width) {
  const std::size_t n = veins_.size();
  std::vector<double> carried(n, 0);
  for (std::size_t i = n; i-- > 1;) {
    if (carried[i] == 0) carried[i] = 1;
    carried[static_cast<std::size_t>(veins_.parent[i])] += carried[i];
  }
  veins_.width.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    veins_.width[i] = static_cast<float>(width * std::pow(carried[i] / std::max(carried[0], 1.0), 1 / kPipe));
  return std::move(veins_);
}

}  // namespace frond
