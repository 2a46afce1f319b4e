#include "land/stream.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "land/flood.h"
#include "rocks/stone.h"

namespace frond {

namespace {

constexpr double kStep = 0.5;                    // metres from point to point of the course
constexpr int kMostCells = 400;                  // of the grid across the square
constexpr double kFreeboard = 0.1;               // metres of the water below the land
constexpr double kFall = 0.003;                  // metres that it falls on each metre at least
constexpr double kRoughness = 0.06;              // Manning's n, s/m^(1/3), of a bed of cobbles
constexpr double kMeander = 11;                  // wavelength of bends by the width
constexpr double kSlowest = 0.15, kFastest = 2;  // metres a second
constexpr double kBeach = 0.4;                   // slope of the bed beside the water
constexpr float kShore = 0.45f;                  // metres of bed beside the water
constexpr int kAcross = 17;                      // columns of the bed

/// The way down from a place to the rim of a square, point by point.
std::vector<Vec2> way_down(Vec2 from, double side, const std::function<double(Vec2)>& land) {
  const int count = std::clamp(static_cast<int>(side), 8, kMostCells);
  const double cell = side / count;
  GroundGrid grid{Vec2(static_cast<float>((cell - side) / 2)), static_cast<float>(cell), count, {}, {}};
  grid.height.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(count));
  parallel_for(grid.height.size(),
               [&](std::size_t k) { grid.height[k] = static_cast<float>(land(grid.place(k))); });
  std::vector<std::size_t> next = priority_flood(grid).next;
  auto index = [&](float at) { return std::clamp(static_cast<int>((at + side / 2) / cell), 0, count - 1); };
  std::size_t point = grid.index(index(from.x), index(from.y));
  std::vector<Vec2> way{grid.place(point)};
  for (; next[point] != point; way.push_back(grid.place(point))) point = next[point];
  return way;
}

/// Each the mean of itself and its neighbours, some times; the ends stay.
template <class T>
void smooth(std::vector<T>& values, int times) {
  for (int round = 0; round < times; ++round) {
    std::vector<T> before = values;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      values[i] = (before[i - 1] + before[i] + before[i + 1]) / 3.0f;
  }
}

std::vector<Vec2> evenly_spaced(const std::vector<Vec2>& line, double step) {
  std::vector<Vec2> points{line.front()};
  double left = step;
  for (std::size_t i = 1; i < line.size(); ++i) {
    double length = glm::distance(line[i - 1], line[i]), gone = 0;
    for (; length - gone >= left; left = step) {
      gone += left;
      points.push_back(glm::mix(line[i - 1], line[i], static_cast<float>(gone / length)));
    }
    left -= length - gone;
  }
  return points;
}

Vec2 direction_at(const std::vector<Vec2>& line, std::size_t i) {
  return glm::normalize(line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]);
}

/// The line with bends to both sides.
std::vector<Vec2> winding(const std::vector<Vec2>& line, double width, Seed seed) {
  constexpr double kBend = 2.2;  // widths that it strays to each side, about
  std::vector<Vec2> bent = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    double along = kStep * static_cast<double>(i) / (kMeander * width);
    Vec2 d = direction_at(line, i);
    bent[i] +=
        static_cast<float>(kBend * width * noise(Vec3(2 * along, seed.child("bend").range(0, 99), 0))) *
        Vec2(-d.y, d.x);
  }
  smooth(bent, static_cast<int>(2 * width / kStep) + 2);
  return evenly_spaced(bent, kStep);
}

}  // namespace

StreamCourse::StreamCourse(const StreamShape& shape, double side, const std::function<double(Vec2)>& land,
                           Seed seed)
    : shape_(shape), seed_(seed) {
  if (shape.width <= 0) return;
  // Rounds of smoothing that take the steps of the grid out of the way down, and out of its fall.
  constexpr int kSmoothWay = 8, kSmoothFall = 12;
  // It is wider and narrower by a share of its width, over so many widths, and comes out of the ground over
  // so many.
  constexpr double kVaries = 0.35, kVariesOver = 3;
  constexpr double kSpringFrom = -0.3, kSpringTo = 3;
  std::vector<Vec2> line = way_down(shape.from, side, land);
  if (line.size() < 4) return;
  smooth(line, kSmoothWay);
  line = winding(evenly_spaced(line, kStep), shape.width, seed);
  std::vector<float> level;
  for (Vec2 at : line) level.push_back(static_cast<float>(land(at) - kFreeboard));
  smooth(level, kSmoothFall);
  for (std::size_t i = 1; i < level.size(); ++i)
    level[i] = std::min(level[i], level[i - 1] - static_cast<float>(kFall * kStep));
  for (std::size_t i = 0; i < line.size(); ++i) {
    double along = kStep * static_cast<double>(i);
    double wide =
        1 + kVaries * noise(Vec3(along / (kVariesOver * shape.width), seed.child("width").range(0, 99), 0));
    // It begins as a spring.
    wide *= smooth_step(kSpringFrom * shape.width, kSpringTo * shape.width, along);
    course_.push_back({line[i], direction_at(line, i), static_cast<float>(along), level[i],
                       static_cast<float>(wide * shape.width / 2)});
  }
  double slope = (level.front() - level.back()) / (kStep * static_cast<double>(level.size() - 1));
  double radius = 2 * shape.depth / 3;  // hydraulic, of a wide parabola
  speed_ = std::clamp(std::pow(radius, 2.0 / 3) * std::sqrt(slope) / kRoughness, kSlowest, kFastest);
}

StreamCourse::Near StreamCourse::near(Vec2 at) const {
  Near best;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < course_.size(); ++i) {
    const StreamPoint &a = course_[i], &b = course_[i + 1];
    Vec2 leg = b.at - a.at, off = at - a.at;
    if (glm::dot(off, off) > least + 1.5 * kStep * (kStep + 2 * std::sqrt(least))) continue;
    float t = std::clamp(glm::dot(off, leg) / glm::dot(leg, leg), 0.0f, 1.0f);
    double away = glm::dot(off - t * leg, off - t * leg);
    if (away >= least) continue;
    least = away;
    best.at = {glm::mix(a.at, b.at, t), a.toward, std::lerp(a.along, b.along, t),
               std::lerp(a.level, b.level, t), std::lerp(a.half, b.half, t)};
  }
  best.away = std::sqrt(least);
  return best;
}

double StreamCourse::distance(Vec2 at) const { return flows() ? near(at).shore() : 1e6; }

double StreamCourse::bed_height(const Near& found) const {
  double out = found.away / std::max<double>(found.at.half, 0.05);
  constexpr double kCobbles = 0.25;                            // of the depth, of cobbles and pools
  constexpr double kCobblesAlong = 0.9, kCobblesAcross = 0.5;  // metres, the size of these
  constexpr double kCobblesEnd = 1.3, kCobblesAll = 0.6;  // by the way to the shore: none, and all of them
  double bed = out < 1 ? -shape_.depth * (1 - out * out) : kBeach * found.shore();
  // Cobbles, and pools between them.
  Vec2 at = found.at.at;
  bed += kCobbles * shape_.depth *
         noise(Vec3(at.x / kCobblesAlong, found.away / kCobblesAcross, at.y / kCobblesAlong)) *
         smooth_step(kCobblesEnd, kCobblesAll, out);
  return found.at.level + bed;
}

double StreamCourse::height(Vec2 at, double land) const { return flows() ? height(near(at), land) : land; }

double StreamCourse::height(const Near& found, double land) const {
  double shore = found.shore();
  // Banks rise gently: they are so many widths of the stream across, and so much by their height.
  constexpr double kBankWidths = 1.5, kBankSlope = 2.5;
  constexpr double kAboveWater = 0.05;  // metres of the bed at most, where the land is as low as that
  double bank = std::max(kBankWidths * shape_.width, kBankSlope * std::abs(land - found.at.level)) + 1;
  if (shore >= bank) return land;
  double bed = std::min(bed_height(found), std::max<double>(land, found.at.level + kAboveWater));
  return bed + (land - bed) * smooth_step(0.0, bank, std::max(shore, 0.0));
}

double StreamCourse::ground(Vec2 at, double land) const {
  constexpr double kBelow = 0.25;  // metres
  if (!flows()) return land;
  Near found = near(at);
  return height(found, land) - kBelow * (1 - smooth_step(0.0, double{kShore}, found.shore()));
}

void StreamCourse::raise(float by) {
  for (StreamPoint& point : course_) point.level += by;
}

Surface StreamCourse::strip(double beyond, int columns,
                            const std::function<Vec3(const StreamPoint&, float)>& place) const {
  Surface mesh;
  for (const StreamPoint& point : course_) {
    for (int k = 0; k < columns; ++k) {
      float across = (point.half + static_cast<float>(beyond)) *
                     (2 * static_cast<float>(k) / static_cast<float>(columns - 1) - 1);
      mesh.position.push_back(place(point, across));
      mesh.uv.emplace_back(point.along, across);
    }
  }
  auto wide = static_cast<std::uint32_t>(columns);
  for (std::uint32_t row = 0; row + 1 < course_.size(); ++row)
    for (std::uint32_t k = 0; k + 1 < wide; ++k) {
      std::uint32_t a = row * wide + k, b = a + 1, c = a + wide, d = c + 1;
      mesh.triangle.push_back({a, b, c});
      mesh.triangle.push_back({b, d, c});
    }
  set_normals(mesh);
  return mesh;
}

Surface StreamCourse::water() const {
  constexpr double kUnderBank = 0.2;  // metres past the shore, where the bed hides it
  constexpr int kWaterColumns = 5;
  return strip(kUnderBank, kWaterColumns, [](const StreamPoint& p, float across) {
    Vec2 at = p.at + across * Vec2(-p.toward.y, p.toward.x);
    return Vec3(at.x, p.level, at.y);
  });
}

Surface StreamCourse::bed() const {
  Surface mesh = strip(kShore, kAcross, [this](const StreamPoint& p, float across) {
    Vec2 at = p.at + across * Vec2(-p.toward.y, p.toward.x);
    double height = bed_height({std::abs(across), p});
    // Its edge goes below the ground beside it.
    constexpr double kEdge = 0.75, kDown = 2;  // share of the shore from which it does, and slope
    double edge = std::abs(across) - p.half - kEdge * kShore;
    return Vec3(at.x, height - kDown * std::max(edge, 0.0), at.y);
  });
  for (std::size_t i = 0; i < mesh.uv.size(); ++i)
    mesh.uv[i] = {course_[i / kAcross].level - mesh.position[i].y, 0};
  return mesh;
}

Solids StreamCourse::stones() const {
  constexpr int kShapes = 6;
  constexpr double kDense = 9;                          // stones on a metre
  constexpr double kInBed = 0.35;                       // share of stones
  constexpr double kShoreFrom = 0.85, kShoreTo = 1.35;  // places of the others, by the way to the shore
  constexpr double kSmallest = 0.05, kRange = 0.4;      // metres
  Solids stones;
  for (std::uint64_t k = 0; k < kShapes; ++k) {
    auto grey = static_cast<float>(seed_.child("grey", k).range(0.34, 0.5));
    stones.add_shape(
        {stone_surface({.seed = seed_.child("stone", k), .roughness = 0.35, .flatness = 0.4}, 3),
         {.matter = Matter::granite, .color = {grey, 0.97f * grey, 0.9f * grey}, .scale = 0.2, .moss = 0.4}});
  }
  double length = flows() ? course_.back().along : 0;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(kDense * length); ++i) {
    Seed own = seed_.child("stones", i);
    const StreamPoint& p =
        course_[static_cast<std::size_t>(own.child(0).unit() * static_cast<double>(course_.size() - 1))];
    // Most lie along the shore; few are large.
    double out = p.half * (own.child(1).unit() < kInBed ? own.child(2).unit()
                                                        : own.child(2).range(kShoreFrom, kShoreTo));
    double size = kSmallest + kRange * std::pow(own.child(3).unit(), 3) * std::min(1.0, 2.0 * p.half);
    double side = own.child(4).unit() < 0.5 ? -1 : 1;
    Vec2 at = p.at + static_cast<float>(side * out) * Vec2(-p.toward.y, p.toward.x);
    double y = bed_height({out, p}) + size * own.child(5).range(-0.25, 0.2);
    stones.place(
        static_cast<std::uint16_t>(own.child(6).bits() % kShapes), Vec3(at.x, y, at.y),
        glm::angleAxis(static_cast<float>(own.child(7).range(0, 2 * kPi)), Vec3(0, 1, 0)),
        static_cast<float>(size) * Vec3(1, own.child(8).range(0.5, 0.8), own.child(9).range(0.75, 1.2)));
  }
  return stones;
}

std::vector<Afloat> StreamCourse::leaves(double time, double loop) const {
  constexpr double kScattered = 0.45, kSwings = 0.3;  // by half the width, across
  constexpr float kAboveWater = 0.004f;               // metres
  constexpr int kAlike = 3;  // in a film that loops, each so many places on is like it
  std::vector<Afloat> list;
  if (!flows() || shape_.leaves < 1) return list;
  const int count = loop > 0 ? (shape_.leaves + kAlike - 1) / kAlike * kAlike : shape_.leaves;
  double length = course_.back().along, apart = length / count, gone = speed_ * time;
  if (loop > 0)
    gone = kAlike * apart * std::max(1.0, std::round(speed_ * loop / (kAlike * apart))) * time / loop;
  for (int k = 0; k < count; ++k) {
    auto like = static_cast<std::uint64_t>(loop > 0 ? k % kAlike : k);
    Seed own = seed_.child("leaf", like);
    double along = std::fmod(apart * (k + own.child(0).unit()) + gone, length);
    // It comes up, and goes down, on two metres.
    double sink = std::min({1.0, along / 2, (length - along) / 2});
    auto i = static_cast<std::size_t>(along / kStep);
    const StreamPoint &a = course_[std::min(i, course_.size() - 2)],
                      &b = course_[std::min(i + 1, course_.size() - 1)];
    auto t = static_cast<float>(along / kStep - static_cast<double>(i));
    double way = along / (kMeander * shape_.width) + own.child(1).unit();
    float across = std::lerp(a.half, b.half, t) * static_cast<float>(kScattered * own.child(2).range(-1, 1) +
                                                                     kSwings * std::sin(2 * kPi * way));
    Vec2 at = glm::mix(a.at, b.at, t) + across * Vec2(-a.toward.y, a.toward.x);
    list.push_back({Vec3(at.x, std::lerp(a.level, b.level, t) + kAboveWater, at.y),
                    static_cast<float>(2 * kPi * (own.child(3).unit() + own.child(4).range(-1, 1) * way)),
                    static_cast<float>(sink * own.child(5).range(0.75, 1.25)),
                    static_cast<int>(own.child(6).bits() % 64)});
  }
  return list;
}

}  // namespace frond
