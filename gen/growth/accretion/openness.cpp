#include "accretion/openness.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frond {

namespace {

constexpr int kLevels = 4;
constexpr std::size_t kConeSteps = 7;  // two on each level, one on the last
constexpr float kWhole = 256;          // parts of the face of a cell, in which areas are counted
constexpr float kFirstStep = 1.5f;     // finest cells, from where a cone begins to its first step
constexpr float kOffSkin = 0.9f;       // finest cells, from the skin to where a cone begins
constexpr float kStepLength = 1.2f;    // cells of the step's level
constexpr float kDark = 0.02f;         // share let through: below it a cone ends
constexpr float kFromAbove = 1.3f;     // light straight from above, beside the 1 from all sides
constexpr float kGround = 1.25f;       // ground takes of that below a height of 1 / this - 1

/// Directions round the pole z: one along it, and two rings.
struct Cone {
  Vec3 direction;
  float share;
};

std::vector<Cone> cones() {
  std::vector<Cone> list{{{0, 0, 1}, 1.0f}};
  auto ring = [&](int count, float height, float turn) {
    float flat = std::sqrt(1 - height * height);
    for (int k = 0; k < count; ++k) {
      float angle = static_cast<float>(2 * kPi) * (static_cast<float>(k) + turn) / static_cast<float>(count);
      list.push_back({{flat * std::cos(angle), flat * std::sin(angle), height}, 1.0f});
    }
  };
  ring(5, 0.76f, 0);
  ring(6, 0.28f, 0.5f);
  ring(6, -0.35f, 0);  // below its own level: open only to what stands out
  return list;
}

}  // namespace

Openness::Openness(Vec3 low, Vec3 high, float cell) : low_(low) {
  glm::ivec3 count = glm::max(glm::ivec3(glm::ceil((high - low) / cell)), 1);
  for (int l = 0; l < kLevels; ++l) {
    std::size_t cells = std::size_t{1} * count.x * count.y * count.z;
    levels_.push_back({count, cell, std::vector<float>(cells), std::vector<char>(cells)});
    count = (count + 1) / 2;
    cell *= 2;
  }
  area_.resize(levels_[0].held.size());
}

void Openness::clear() { std::ranges::fill(area_, 0); }

void Openness::add(Vec3 at, float area) {
  const Level& fine = levels_[0];
  glm::ivec3 i(glm::floor((at - low_) / fine.cell));
  if (glm::any(glm::lessThan(i, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(i, fine.count))) return;
  area_[fine.at(i.x, i.y, i.z)] += static_cast<std::int32_t>(kWhole * area / (fine.cell * fine.cell));
}

void Openness::build() {
  Level& fine = levels_[0];
  for (std::size_t i = 0; i < area_.size(); ++i)
    fine.held[i] = std::min(1.0f, static_cast<float>(area_[i]) / kWhole);
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const Level& from = levels_[l - 1];
    Level& to = levels_[l];
    for (int z = 0; z < to.count.z; ++z)
      for (int y = 0; y < to.count.y; ++y)
        for (int x = 0; x < to.count.x; ++x) {
          // What a cell holds up is the mean over its face of what its two layers let through.
          float sum = 0;
          for (int k = 0; k < 8; ++k) {
            int u = 2 * x + (k & 1), v = 2 * y + (k >> 1 & 1), w = 2 * z + (k >> 2);
            if (u < from.count.x && v < from.count.y && w < from.count.z) sum += from.held[from.at(u, v, w)];
          }
          to.held[to.at(x, y, z)] = std::min(1.0f, sum / 4);
        }
  }
  for (Level& level : levels_) mark(level);
}

void Openness::mark(Level& level) {
  const int wide = level.count.x, high = level.count.y, deep = level.count.z;
  for (int z = 0; z + 1 < deep; ++z)
    for (int y = 0; y + 1 < high; ++y) {
      const float* front = level.held.data() + (z * high + y) * wide;
      const float* back = front + wide * high;
      char* anything = level.anything.data() + (std::ptrdiff_t{z} * high + y) * wide;
      auto column = [&](int x) { return front[x] + front[x + wide] + back[x] + back[x + wide]; };
      for (int x = 0; x + 1 < wide; ++x) anything[x] = column(x) + column(x + 1) > 0;
    }
}

/// At a place measured in its cells, from the middle of the first.
inline float Openness::held_at(const Level& level, Vec3 at) {
  const int wide = level.count.x, high = level.count.y, deep = level.count.z;
  // The outermost cells are empty.
  if (!(at.x >= 0 && at.y >= 0 && at.z >= 0)) return 0;
  int x = static_cast<int>(at.x), y = static_cast<int>(at.y), z = static_cast<int>(at.z);
  if (x + 1 >= wide || y + 1 >= high || z + 1 >= deep) return 0;
  std::ptrdiff_t cell = (std::ptrdiff_t{z} * high + y) * wide + x;
  if (!level.anything[cell]) return 0;
  Vec3 t = at - Vec3(x, y, z);
  const float* held = level.held.data() + cell;
  auto row = [&](int v, int w) {
    const float* cells = held + (std::ptrdiff_t{w} * high + v) * wide;
    return cells[0] * (1 - t.x) + cells[1] * t.x;
  };
  float front = row(0, 0) * (1 - t.y) + row(1, 0) * t.y;
  float back = row(0, 1) * (1 - t.y) + row(1, 1) * t.y;
  return front * (1 - t.z) + back * t.z;
}

float Openness::openness(Vec3 at, Vec3 normal, float light) const {
  static const std::vector<Cone> kCones = cones();
  Vec3 side = std::abs(normal.y) < 0.9f ? glm::normalize(glm::cross(normal, Vec3(0, 1, 0))) : Vec3(1, 0, 0);
  side = glm::normalize(side - normal * glm::dot(side, normal));
  Vec3 other = glm::cross(normal, side);
  float cell = levels_[0].cell, come = 0, all = 0;
  // Where cones begin, and how far away their steps are, in cells of the level of each step.
  std::array<Vec3, kConeSteps> from;
  std::array<float, kConeSteps> distance;
  float away = kFirstStep * cell;
  for (std::size_t step = 0; step < kConeSteps; ++step) {
    float size = levels_[step / 2].cell;
    from[step] = (at + normal * (kOffSkin * cell) - low_) / size - 0.5f;
    distance[step] = away / size;
    away += size * kStepLength;
  }
  for (const Cone& cone : kCones) {
    Vec3 direction = side * cone.direction.x + other * cone.direction.y + normal * cone.direction.z;
    float weight = cone.share * (0.5f + 0.5f * std::abs(cone.direction.z));
    all += weight;
    // Ground holds up what comes from below.
    float source = kFromAbove * light * std::max(0.0f, direction.y) +
                   (1 - light) * std::min(1.0f, kGround * (1 + direction.y));
    if (source <= 0) continue;
    float through = 1;
    for (std::size_t step = 0; step < kConeSteps && through > kDark; ++step)
      through *= 1 - std::min(1.0f, held_at(levels_[step / 2], from[step] + direction * distance[step]));
    come += weight * source * through;
  }
  return come / all;
}

}  // namespace frond
