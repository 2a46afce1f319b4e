#include "land/mountain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/noise.h"
#include "core/seed.h"

namespace frond {

namespace {

// v of the surface, as the header says.
constexpr double kWoods = 0, kScreeCover = 1.0 / 3, kBareRock = 2.0 / 3, kSnowCover = 1;

constexpr int kColumns = 420, kRows = 190;
constexpr float kDeep = 1.8f;         // how much longer cells are away from the eye than across
constexpr int kSteps = 70;            // of rising and being worn
constexpr double kWear = 0.055;       // of a step, on a slope with one cell above it
constexpr double kConcave = 0.45;     // power of what is drained
constexpr double kSteepest = 1.15;    // cell heights a cell: what is steeper falls
constexpr double kLongestStep = 1.2;  // cells to the next, for that

// The land that rises, by eye; u and v are shares of the width and of the way from front to back.
constexpr double kCrest = 0.58, kCrestWanders = 0.10;  // v of the crest, and how far it strays
constexpr double kHalfRange = 0.5;                     // in v, from the crest to where nothing rises
constexpr double kEndsRise = 0.3, kEndsFall = 0.62;    // u up to which it rises, and from which it sinks
constexpr double kTops = 0.75, kTopsVary = 0.45;       // how much it rises, and how uneven that is
constexpr double kFirstGround = 0.4;                   // cells of unevenness to begin with

/// Heights in cells, row by row; rows from the plain in front to the one behind.
class Range {
 public:
  explicit Range(Seed seed)
      : height_(kColumns * kRows),
        rise_(height_.size()),
        below_(height_.size()),
        drained_(height_.size()),
        order_(height_.size()) {
    Vec3 shift(seed.range(-99, 99), 0, 0);
    for (int z = 0; z < kRows; ++z)
      for (int x = 0; x < kColumns; ++x) {
        double u = (x + 0.5) / kColumns, v = (z + 0.5) / kRows;
        Vec3 at(6 * u, 0, 3 * v);
        // A crest that wanders, higher here and lower there, and runs out at both ends.
        double crest = kCrest + kCrestWanders * noise(Vec3(3.0f * static_cast<float>(u), 7, 0) + shift);
        double across = std::clamp(1 - std::abs(v - crest) / kHalfRange, 0.0, 1.0);
        double ends = smooth_step(0.0, kEndsRise, u) * (1 - smooth_step(kEndsFall, 1.0, u));
        double tops = kTops + kTopsVary * fractal_noise(at + shift, 3);
        rise_[index(x, z)] = std::max(0.0, across * ends * tops);
        height_[index(x, z)] = kFirstGround + kFirstGround * noise(at * 17.0f + shift);
      }
    std::iota(order_.begin(), order_.end(), 0);
    for (int step = 0; step < kSteps; ++step) wear();
    // Frost and wind take the edges.
    std::vector<double> sharp = height_;
    for (int z = 1; z + 1 < kRows; ++z)
      for (int x = 1; x + 1 < kColumns; ++x) {
        double sum = 0;
        for (int dz = -1; dz <= 1; ++dz)
          for (int dx = -1; dx <= 1; ++dx)
            sum += sharp[index(x + dx, z + dz)] * (dx == 0 ? 2 : 1) * (dz == 0 ? 2 : 1);
        height_[index(x, z)] = sum / 16;
      }
  }

  double at(int x, int z) const {
    return height_[index(std::clamp(x, 0, kColumns - 1), std::clamp(z, 0, kRows - 1))];
  }
  double drained(int x, int z) const { return drained_[index(x, z)]; }
  double top() const { return *std::max_element(height_.begin(), height_.end()); }

 private:
  static std::size_t index(int x, int z) { return static_cast<std::size_t>(z * kColumns + x); }
  void wear() {
    for (std::size_t i = 0; i < height_.size(); ++i) height_[i] += rise_[i];
    std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return height_[a] < height_[b]; });
    for (std::size_t i : order_) find_below(i);
    std::fill(drained_.begin(), drained_.end(), 1.0);
    for (auto i = order_.rbegin(); i != order_.rend(); ++i)
      if (below_[*i] != *i) drained_[below_[*i]] += drained_[*i];
    // From the foot upward, each with what lies below it as it is by then.
    for (std::size_t i : order_) {
      std::size_t to = below_[i];
      if (to == i) {
        if (edge(i)) height_[i] = 0;
        continue;
      }
      double cut = kWear * std::pow(drained_[i], kConcave) / spacing_;
      height_[i] = (height_[i] + cut * height_[to]) / (1 + cut);
      height_[i] = std::min(height_[i], height_[to] + kSteepest * kLongestStep);
    }
  }

  static bool edge(std::size_t i) {
    auto z = static_cast<int>(i) / kColumns, x = static_cast<int>(i) % kColumns;
    return z == 0 || z == kRows - 1 || x == 0 || x == kColumns - 1;
  }

  void find_below(std::size_t i) {
    below_[i] = i;
    if (edge(i)) return;
    double steepest = 0;
    for (int dz = -1; dz <= 1; ++dz)
      for (int dx = -1; dx <= 1; ++dx) {
        std::size_t to = i + static_cast<std::size_t>(dz * kColumns + dx);
        double drop = (height_[i] - height_[to]) / std::hypot(dx, dz + 1e-9);
        if (drop > steepest) steepest = drop, below_[i] = to;
      }
  }

  static constexpr double spacing_ = 1.1;  // cells from one to the next, about
  std::vector<double> height_, rise_;
  std::vector<std::size_t> below_;
  std::vector<double> drained_;
  std::vector<std::size_t> order_;
};

}  // namespace

Surface mountain_surface(const MountainShape& shape, Vec3 sun) {
  Range range(Seed{static_cast<std::uint64_t>(shape.seed)});
  double cell = shape.width / kColumns, scale = shape.height / range.top();
  double turn = radians(shape.toward);
  Vec3 ahead(std::sin(turn), 0, std::cos(turn)), aside(ahead.z, 0, -ahead.x);
  auto height = [&](int x, int z) {
    double h = range.at(x, z) * scale;
    // Towers and ledges of bare rock, the more the higher.
    constexpr float kTowers = 0.21f, kLedges = 0.35f;  // on a cell
    constexpr double kBroken = 0.025;                  // of the height
    Vec3 p(static_cast<float>(x) * kTowers, static_cast<float>(h / cell) * kLedges,
           static_cast<float>(z) * kTowers);
    return h + kBroken * h * std::min(1.0, h / shape.height + 0.2) * (fractal_noise(p, 4) - 0.2);
  };
  std::vector<float> heights;
  for (int z = 0; z < kRows; ++z)
    for (int x = 0; x < kColumns; ++x) heights.push_back(static_cast<float>(height(x, z)));
  auto at = [&](int x, int z) {
    return heights[static_cast<std::size_t>(std::clamp(z, 0, kRows - 1) * kColumns +
                                            std::clamp(x, 0, kColumns - 1))];
  };
  Vec2 down(glm::dot(sun, aside), glm::dot(sun, ahead) / kDeep);  // toward the sun, in cells
  // A shadow is looked for at ever longer ways toward the sun, in cells.
  constexpr float kShadowFirst = 1.5f, kShadowLast = 60, kShadowNext = 1.25f;
  constexpr int kAway = 3;                              // cells to what a hollow is measured by
  constexpr double kSkyShare = 0.25, kSunShare = 0.75;  // of all light
  // Rise over run, by eye: woods and snow do not hold on what is steeper, scree lies on what is less steep.
  constexpr double kSteepWood = 1.7, kSteepSnow = 0.9, kSteepScree = 0.7;
  constexpr double kGully = 3.5;  // log2 of the cells that drain through one
  Surface out;
  for (int z = 0; z < kRows; ++z) {
    for (int x = 0; x < kColumns; ++x) {
      float h = at(x, z), step = static_cast<float>(cell);
      Vec2 slope((at(x + 1, z) - at(x - 1, z)) / (2 * step),
                 (at(x, z + 1) - at(x, z - 1)) / (2 * kDeep * step));
      Vec3 normal = glm::normalize(Vec3(0, 1, 0) - aside * slope.x - ahead * slope.y);
      out.position.push_back(
          aside * (static_cast<float>(x - kColumns / 2) * step) +
          ahead * (static_cast<float>(shape.distance) +
                   (static_cast<float>(z) - static_cast<float>(kCrest) * kRows) * kDeep * step) +
          Vec3(0, h, 0));
      out.normal.push_back(normal);
      bool shaded = false;
      for (float k = kShadowFirst; k < kShadowLast && !shaded; k *= kShadowNext)
        shaded = at(x + static_cast<int>(std::lround(down.x * k)),
                    z + static_cast<int>(std::lround(down.y * k))) > h + sun.y * k * step + 0.2f * step;
      double hollow = (at(x - kAway, z) + at(x + kAway, z) + at(x, z - kAway) + at(x, z + kAway)) / 4 - h;
      double sky = std::clamp(0.5 + 0.5 * normal.y - 0.25 * hollow / cell, 0.15, 1.0);
      double light = kSkyShare * sky + (shaded ? 0.0 : kSunShare * std::max(0.0f, glm::dot(normal, sun)));
      double steep = glm::length(slope),
             rough = fractal_noise(Vec3(static_cast<float>(x) * 0.09f, 3, static_cast<float>(z) * 0.09f), 4);
      double line = shape.woods * shape.height * (1 + 0.35 * rough);
      double cover = h < line && steep < kSteepWood + 0.6 * rough ? kWoods : kBareRock;
      double gully = std::log2(std::max(1.0, range.drained(x, z)));
      if (cover > 0 && gully > kGully && steep < kSteepScree) cover = kScreeCover;
      if (h > shape.snow * (1 + 0.12 * rough) && steep < kSteepSnow + 0.4 * rough) cover = kSnowCover;
      out.uv.emplace_back(light, cover);
    }
  }
  for (int z = 0; z + 1 < kRows; ++z)
    for (int x = 0; x + 1 < kColumns; ++x) {
      auto i = static_cast<std::uint32_t>(z * kColumns + x);
      out.triangle.push_back({i, i + kColumns + 1, i + 1});
      out.triangle.push_back({i, i + kColumns, i + kColumns + 1});
    }
  return out;
}

}  // namespace frond
