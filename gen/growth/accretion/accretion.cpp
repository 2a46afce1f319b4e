#include "accretion/accretion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "accretion/openness.h"
#include "accretion/skin_mesh.h"
#include "core/noise.h"
#include "core/parallel.h"

namespace frond {

namespace {

constexpr int kSteps = 16;              // of its growth that are kept
constexpr std::size_t kBatch = 512;     // vertices that one thread takes at a time
constexpr int kLook = 2, kLookAll = 8;  // layers after which what grows looks round, and all do
constexpr float kMargin = 0.6f;         // edges that are left free before what stands in the way
constexpr float kKnownRoom = 8;         // edges: free room is known as far as this
constexpr float kShadeBox = 1.3f;       // of the reach: beyond it nothing shades
constexpr float kShadeCell = 1.6f;      // edges

template <class Body>
void for_all(std::size_t count, const Body& body) {
  parallel_for((count + kBatch - 1) / kBatch, [&](std::size_t b) {
    for (std::size_t i = b * kBatch; i < std::min(count, (b + 1) * kBatch); ++i) body(i);
  });
}

/// The light round a skin, which changes little from place to place: asked at corners of a few boxes.
class LightAround {
 public:
  LightAround(const std::function<float(Vec3)>& light, Vec3 low, Vec3 high) : low_(low), size_(high - low) {
    for (int i = 0; light && i < kSide * kSide * kSide; ++i)
      at_.push_back(
          light(low + size_ * Vec3(i % kSide, i / kSide % kSide, i / kSide / kSide) / (kSide - 1.0f)));
  }

  float operator()(Vec3 at) const {
    if (at_.empty()) return 1;
    assert(std::isfinite(glm::dot(at, at)) && "a skin of finite places");
    Vec3 g = glm::clamp((at - low_) / size_, Vec3(0), Vec3(0.9999f)) * (kSide - 1.0f);
    Vec3 f = glm::floor(g), t = g - f;
    float sum = 0;
    for (int k = 0; k < 8; ++k) {
      glm::ivec3 c = glm::ivec3(f) + glm::ivec3(k & 1, k >> 1 & 1, k >> 2);
      Vec3 w((k & 1) ? t.x : 1 - t.x, (k >> 1 & 1) ? t.y : 1 - t.y, (k >> 2) ? t.z : 1 - t.z);
      sum += w.x * w.y * w.z * at_[static_cast<std::size_t>((c.z * kSide + c.y) * kSide + c.x)];
    }
    return sum;
  }

 private:
  static constexpr int kSide = 5;
  Vec3 low_, size_;
  std::vector<float> at_;
};

/// One skin while it grows.
class Skin {
 public:
  Skin(const Accretion& law, const AccretionWorld& world, Seed seed)
      : law_(law),
        world_(world),
        edge_(static_cast<float>(law.edge)),
        reach_(static_cast<float>(std::max(law.across, law.up))),
        layer_(reach_ / static_cast<float>(law.layers)),
        shape_(law.across, law.up, law.across),
        shade_(Vec3(-kShadeBox * shape_.x, -2 * edge_, -kShadeBox * shape_.z), kShadeBox * shape_,
               kShadeCell * edge_),
        light_(world.light, Vec3(-shape_.x, 0, -shape_.z), shape_) {
    for (int axis = 0; axis < 3; ++axis)
      lot_[axis] = static_cast<float>(seed.child("lumps", static_cast<std::uint64_t>(axis)).range(-99, 99));
    constexpr float kLeastFirst = 2.5f, kFirst = 0.06f;  // radius of the first ball: edges; of the reach
    constexpr float kRaised = 0.2f;                      // of that radius
    float first = std::max(kLeastFirst * edge_, kFirst * reach_);
    mesh_.start(Vec3(0, kRaised * first, 0), first, edge_);
    resize();
    keep();
    for (int l = 0; l < law.layers; ++l) {
      grow(l + 1);
      if ((l + 1) * kSteps / law.layers > l * kSteps / law.layers) keep();
    }
  }

  Accreted finish() &&;

 private:
  void grow(int layer);
  /// Finds out how open each place that grows is, or each one.
  void look(bool all);
  void resize() {
    for (auto* list : {&open_, &lump_, &clearance_, &speed_, &laid_}) list->resize(mesh_.position.size(), 0);
    alive_.resize(mesh_.position.size(), 1);
  }
  void keep() { past_.push_back(mesh_.position); }
  Vec3 before(std::size_t step, std::uint32_t vertex, std::vector<Vec3>& known,
              std::vector<char>& is_known) const;

  const Accretion& law_;
  const AccretionWorld& world_;
  float edge_, reach_, layer_;
  Vec3 shape_;  // how far it reaches, to its sides and up
  Vec3 lot_{0};
  Openness shade_;
  LightAround light_;
  SkinMesh mesh_;
  float most_open_ = 1;
  // One entry for each vertex; in past_ a list of these for each step kept:
  std::vector<char> alive_;       // whether a triangle still has the vertex
  std::vector<float> open_;       // see Openness::openness()
  std::vector<float> lump_;       // how much more than others the polyps of the vertex lay
  std::vector<float> clearance_;  // metres that are free round the vertex, at least
  std::vector<float> speed_;      // layers a layer
  std::vector<float> laid_;       // the last layer in which the vertex moved much
  std::vector<std::vector<Vec3>> past_;
};

void Skin::look(bool all) {
  constexpr float kStill = 0.05f;  // layers a layer
  shade_.clear();
  std::size_t count = mesh_.position.size();
  std::ranges::fill(alive_, 0);
  for (auto [a, b, c] : mesh_.triangle) {
    const Vec3 &p = mesh_.position[a], &q = mesh_.position[b], &r = mesh_.position[c];
    shade_.add((p + q + r) / 3.0f, glm::length(glm::cross(q - p, r - p)) / 2);
    alive_[a] = alive_[b] = alive_[c] = 1;
  }
  shade_.build();
  auto lumps = static_cast<float>(law_.lumps), frequency = static_cast<float>(1 / law_.lump_size);
  for_all(count, [&](std::size_t v) {
    // Little changes where nothing grows any more.
    if (!alive_[v] || (speed_[v] < kStill && !all)) return;
    Vec3 at = mesh_.position[v];
    open_[v] = shade_.openness(at, mesh_.normal[v], static_cast<float>(law_.light)) *
               glm::mix(1.0f, light_(at), static_cast<float>(law_.light));
    lump_[v] = 1 + lumps * static_cast<float>(fractal_noise(at * frequency + lot_, 2));
  });
  // The vertex that is most in the open grows by a layer.
  most_open_ = 1e-3f;
  for (const auto& t : mesh_.triangle) most_open_ = std::max(most_open_, open_[t[0]]);
}

void Skin::grow(int layer) {
  constexpr float kStarved = 0.15f, kWellFed = 0.9f;  // of what is most in the open
  constexpr float kSlows = 0.8f, kStops = 1.1f;       // of the reach
  constexpr float kFastest = 1.5f;                    // layers a layer
  constexpr float kAskAgain = 3;                      // edges of known room, below which it is asked for
  constexpr float kMostGained = 1.3f;                 // of its own speed, by what neighbours share
  constexpr float kLays = 0.15f;                      // layers a layer, from which a vertex counts as growing
  // What the vertices see changes little from layer to layer.
  if (layer % kLook == 1) look(layer % kLookAll == 1);
  std::size_t count = mesh_.position.size();
  auto hunger = static_cast<float>(law_.hunger), upward = static_cast<float>(law_.upward);
  for_all(count, [&](std::size_t v) {
    speed_[v] = 0;
    if (!alive_[v]) return;
    Vec3 at = mesh_.position[v], n = mesh_.normal[v];
    // A body that is to be wider than high grows faster to its sides.
    float pace = glm::length(n * shape_) / reach_;
    float fed = std::pow(std::max(smooth_step(kStarved, kWellFed, open_[v] / most_open_), 1e-3f), hunger);
    float rise = 1 + upward * n.y;
    float speed = pace * fed * std::max(0.0f, rise) * std::max(0.0f, lump_[v]);
    if (at.y < 0) speed *= std::max(0.0f, 1 + at.y / edge_);
    // Growth slows where the skin has come as far as it may.
    float gone = glm::length(at / shape_);
    speed *= 1 - smooth_step(kSlows, kStops, gone);
    speed = std::min(speed, kFastest);
    if (speed > 1e-3f && world_.room) {
      if (clearance_[v] < kAskAgain * edge_) clearance_[v] = world_.room(at, kKnownRoom * edge_);
      clearance_[v] = std::min(clearance_[v], kKnownRoom * edge_);
      speed *= smooth_step(kMargin * edge_, 2 * edge_, clearance_[v]);
    }
    speed_[v] = speed;
  });
  // Polyps share what they catch with their neighbours.
  std::vector<float> near = means_of_neighbours(mesh_.triangle, speed_);
  for (std::size_t v = 0; v < count; ++v) {
    float speed = std::min(speed_[v] * kMostGained, 0.5f * speed_[v] + 0.5f * near[v]);
    mesh_.position[v] += mesh_.normal[v] * (speed * layer_);
    if (clearance_[v] > 0) clearance_[v] -= kFastest * layer_;
    if (speed > kLays) laid_[v] = static_cast<float>(layer);
  }
  auto smoothing = static_cast<float>(law_.smoothing);
  mesh_.relax(0.4f, 0.3f * smoothing);
  std::size_t old = mesh_.position.size();
  mesh_.remesh(edge_, layer % 2 == 0);
  resize();
  for (std::size_t v = old; v < mesh_.position.size(); ++v) {
    auto [a, b] = mesh_.parents[v];
    laid_[v] = std::max(laid_[a], laid_[b]);
    open_[v] = (open_[a] + open_[b]) / 2;
    lump_[v] = (lump_[a] + lump_[b]) / 2;
    speed_[v] = (speed_[a] + speed_[b]) / 2;
  }
}

/// Where a vertex was at a step: what was not there yet lay between those that it came up between.
Vec3 Skin::before(std::size_t step, std::uint32_t vertex, std::vector<Vec3>& known,
                  std::vector<char>& is_known) const {
  if (vertex < past_[step].size()) return past_[step][vertex];
  if (is_known[vertex]) return known[vertex];
  auto [a, b] = mesh_.parents[vertex];
  is_known[vertex] = 1;
  return known[vertex] = (before(step, a, known, is_known) + before(step, b, known, is_known)) * 0.5f;
}

Accreted Skin::finish() && {
  Accreted made;
  look(true);
  std::vector<std::uint32_t> order, list = mesh_.living(order);
  for (std::uint32_t v : list) {
    made.surface.position.push_back(mesh_.position[v]);
    made.birth.push_back(laid_[v] / static_cast<float>(law_.layers));
    made.shade.push_back(1 - std::min(1.0f, open_[v] / most_open_));
  }
  for (auto [a, b, c] : mesh_.triangle) made.surface.triangle.push_back({order[a], order[b], order[c]});
  set_normals(made.surface);
  for (std::size_t step = 0; step + 1 < past_.size(); ++step) {
    std::vector<Vec3> known(mesh_.position.size());
    std::vector<char> is_known(mesh_.position.size());
    std::vector<Vec3>& places = made.past.emplace_back();
    for (std::uint32_t v : list) places.push_back(before(step, v, known, is_known));
  }
  return made;
}

}  // namespace

Accreted accrete(const Accretion& law, const AccretionWorld& world, Seed seed) {
  return Skin(law, world, seed).finish();
}

}  // namespace frond
