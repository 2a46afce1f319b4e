#include "settings/forest_floor.h"

#include <algorithm>
#include <cmath>
#include <compare>

#include "core/cell_grid.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "land/litter.h"

namespace frond {

namespace {

constexpr double kSide = 0.4;           // metres, of a patch
constexpr double kNear = 7, kFar = 14;  // metres from the camera: all of it lies there, none of it does
constexpr int kShapes = 4;              // of litter, of thin litter that lies on paths and moss, and of moss

/// Where the camera is over the film, no two places nearer than half a metre.
std::vector<Vec2> camera_places(const Film& film, const Camera& camera) {
  std::vector<Vec2> places;
  for (int frame = 1; frame <= film.frames; ++frame) {
    Vec3 at = camera.location.at(film.time(frame));
    if (places.empty() || glm::distance(places.back(), Vec2(at.x, at.z)) > 0.5f)
      places.emplace_back(at.x, at.z);
  }
  return places;
}

/// Squares of a grid, those of a row in one place.
struct Cell {
  long long row = 0, column = 0;
  auto operator<=>(const Cell&) const = default;
};

/// The squares within kFar of a place, each once, row by row, and how far the nearest place is from any
/// point: as much work as there are squares, wherever the camera goes.
class NearCells {
 public:
  explicit NearCells(const std::vector<Vec2>& places) : near_(static_cast<float>(kFar)), places_(places) {
    std::uint32_t who = 0;
    for (Vec2 place : places) {
      near_.add(Vec3(place.x, 0, place.y), who++);
      for (long long row = first(place.y); row <= last(place.y); ++row)
        for (long long column = first(place.x); column <= last(place.x); ++column)
          cells_.push_back({row, column});
      if (cells_.size() > 2 * distinct_ + kSpare) thin();
    }
    thin();
  }

  const std::vector<Cell>& cells() const { return cells_; }

  /// Metres to the nearest place; more than kFar where that is farther.
  double away(Vec2 at) const {
    float least = 1e9f;
    near_.each(Vec3(at.x, 0, at.y),
               [&](std::uint32_t who) { least = std::min(least, glm::distance(places_[who], at)); });
    return static_cast<double>(least);
  }

 private:
  static constexpr std::size_t kSpare = 1'000'000;
  static long long first(float x) { return static_cast<long long>(std::floor((x - kFar) / kSide)); }
  static long long last(float x) { return static_cast<long long>(std::ceil((x + kFar) / kSide)); }
  void thin() {
    std::ranges::sort(cells_);
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    distinct_ = cells_.size();
  }

  CellGrid near_;
  const std::vector<Vec2>& places_;
  std::vector<Cell> cells_;
  std::size_t distinct_ = 0;
};

Patch laid(const ForestLand& land, int first_shape, Vec2 at, const Seed& seed) {
  float step = static_cast<float>(kSide / 2);
  Vec2 slope(land.height(at + Vec2(step, 0)) - land.height(at - Vec2(step, 0)),
             land.height(at + Vec2(0, step)) - land.height(at - Vec2(0, step)));
  int shape = first_shape + static_cast<int>(seed.child("shape").bits() % kShapes);
  return {shape, Vec3(at.x, land.height(at), at.y), seed.child("turn").range(0, 2 * kPi), slope / (2 * step)};
}

/// Metres aside of a line that goes straight on behind both ends, negative on its left.
double aside_of(const std::vector<Vec2>& line, Vec2 at) {
  double least = 1e9, aside = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    Vec2 along = line[i + 1] - line[i], from = at - line[i];
    double share = static_cast<double>(glm::dot(from, along) / std::max(glm::dot(along, along), 1e-9f));
    if (i > 0) share = std::max(share, 0.0);
    if (i + 2 < line.size()) share = std::min(share, 1.0);
    double away = static_cast<double>(glm::length(from - along * static_cast<float>(share)));
    if (away >= least) continue;
    least = away;
    aside = along.x * from.y < along.y * from.x ? -away : away;
  }
  return aside;
}

}  // namespace

double mossiness(const ForestLand& land, double share, Vec2 at, Seed seed) {
  if (land.moss) share *= land.moss(at);
  if (share <= 0) return 0;
  Vec3 shift(seed.child("x").range(0, 99), 0, seed.child("z").range(0, 99));
  double patch = fractal_noise(Vec3(at.x, 0, at.y) * (1 / 2.6f) + shift, 3);
  double steep = std::hypot(land.height(at + Vec2(0.5f, 0)) - land.height(at - Vec2(0.5f, 0)),
                            land.height(at + Vec2(0, 0.5f)) - land.height(at - Vec2(0, 0.5f)));
  // The noise is about normal; the logistic curve stands for its distribution.
  double wanted = std::clamp(share, 0.001, 0.999), level = 0.25 * std::log(wanted / (1 - wanted));
  double kept_off = 1 - smooth_step(0.0, 1.2, land.path(at));
  return std::clamp(0.5 + 0.8 * (patch + level - 0.5 * steep - kept_off), 0.0, 1.0);
}

void mark_floor(Surface& floor, const ForestLand& land, double moss, Seed seed) {
  floor.uv.clear();
  for (const Vec3& p : floor.position) {
    Vec2 at(p.x, p.z);
    floor.uv.emplace_back(static_cast<float>(std::clamp(land.path(at), -4.0, 8.0)),
                          static_cast<float>(mossiness(land, moss, at, seed)));
  }
}

double mountain_cover_on(const ForestLand& land, const AltitudeLines& lines, Vec2 at) {
  constexpr float kAside = 9;  // metres
  double here = land.height(at), left = land.height(at - Vec2(kAside, 0)),
         right = land.height(at + Vec2(kAside, 0)), back = land.height(at - Vec2(0, kAside)),
         front = land.height(at + Vec2(0, kAside));
  Vec2 slope(right - left, front - back);
  double hollow = (left + right + back + front) / 4 - here;
  return mountain_cover_at(lines, {at, here, slope / (2 * kAside), hollow / static_cast<double>(kAside)});
}

void mark_mountain(Surface& floor, const ForestLand& land, const AltitudeLines& lines,
                   const std::vector<Vec2>& path, double width) {
  floor.uv.assign(floor.position.size(), Vec2(0));
  parallel_for(floor.position.size(), [&](std::size_t i) {
    Vec2 at(floor.position[i].x, floor.position[i].z);
    floor.uv[i] =
        Vec2(std::clamp(2 * aside_of(path, at) / width, -9.0, 9.0), mountain_cover_on(land, lines, at));
  });
}

ForestCover strew_floor(const Film& film, const Camera& camera, const ForestLand& land, double moss,
                        Seed seed) {
  ForestCover cover;
  LitterShape thick{.side = 1.1 * kSide}, thin = thick;
  thin.leaves *= 0.16, thin.twigs *= 0.5;
  for (std::uint64_t i = 0; i < 2 * kShapes; ++i)
    cover.litter.push_back(litter_surface(i < kShapes ? thick : thin, seed.child("litter", i)));
  for (std::uint64_t i = 0; i < kShapes; ++i)
    cover.moss.push_back(moss_surface(1.5 * kSide, seed.child("cushion", i)));
  std::vector<Vec2> eyes = camera_places(film, camera);
  NearCells near(eyes);
  // Patches lie on one grid for the whole world, so that another camera finds the same ones.
  for (auto [row, column] : near.cells()) {
    Seed own = seed.child("row", static_cast<std::uint64_t>(row)).child(static_cast<std::uint64_t>(column));
    Vec2 at((static_cast<double>(column) + own.child("x").unit()) * kSide,
            (static_cast<double>(row) + own.child("z").unit()) * kSide);
    if (own.child("far").unit() < smooth_step(kNear, kFar, near.away(at))) continue;
    double edge = land.path(at) + own.child("edge").range(-0.25, 0.25);
    bool green = mossiness(land, moss, at, seed) > own.child("moss").range(0.46, 0.58);
    cover.litter_patches.push_back(laid(land, green || edge < 0 ? kShapes : 0, at, own));
    if (green) cover.moss_patches.push_back(laid(land, 0, at, own.child("cushion")));
  }
  return cover;
}

Color litter_at(const Color& mean, double year) {
  static const Curve kFresh({{-0.1, 0.8}, {0.15, 0.25}, {0.5, 0}, {0.8, 0.15}, {0.9, 1}, {1.15, 0.25}});
  constexpr Color kFallen{0.70f, 0.42f, 0.18f};
  auto fresh = static_cast<float>(kFresh(year - std::floor(year)));
  return mixed(mean, kFallen, 0.6f * fresh);
}

}  // namespace frond
