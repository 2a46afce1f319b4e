#include "land/scatter.h"

#include <cmath>

namespace frond {

namespace {

constexpr float kHalf = 16384;  // metres, half a side of the outermost square; what lies beyond is held, too
constexpr int kDeepest = 24;    // quarterings; the smallest squares are 1 mm wide
constexpr int kMostInList = 8;

std::int32_t quarter_of(Vec2 at, Vec2 middle) { return (at.x >= middle.x) + 2 * (at.y >= middle.y); }

Vec2 middle_of(Vec2 middle, float half, std::int32_t quarter) {
  return middle + Vec2(quarter & 1 ? half : -half, quarter & 2 ? half : -half) * 0.5f;
}

}  // namespace

/// Adds a spot to the list of a square.
void TakenSpots::put(std::size_t square, std::int32_t spot) {
  Square& s = square_[square];
  next_[static_cast<std::size_t>(spot)] = s.first;
  s.first = spot;
  ++s.count;
}

void TakenSpots::quarter(std::size_t square, Vec2 middle) {
  auto child = static_cast<std::int32_t>(square_.size());
  square_.resize(square_.size() + 4);
  for (std::int32_t i = square_[square].first; i >= 0;) {
    const Spot& spot = spot_[static_cast<std::size_t>(i)];
    std::int32_t next = next_[static_cast<std::size_t>(i)];
    auto part = static_cast<std::size_t>(child + quarter_of(spot.at, middle));
    square_[part].widen(spot);
    put(part, i);
    i = next;
  }
  square_[square].child = child;
  square_[square].first = -1;
}

void TakenSpots::add(const Spot& spot) {
  auto index = static_cast<std::int32_t>(spot_.size());
  spot_.push_back(spot);
  next_.push_back(-1);
  if (square_.empty()) square_.emplace_back();
  Vec2 middle(0);
  float half = kHalf;
  std::size_t at = 0;
  for (int depth = 0;; ++depth) {
    Square& s = square_[at];
    s.widen(spot);
    if (s.child < 0 && (s.count < kMostInList || depth == kDeepest)) return put(at, index);
    if (s.child < 0) quarter(at, middle);
    std::int32_t part = quarter_of(spot.at, middle);
    middle = middle_of(middle, half, part);
    half /= 2;
    at = static_cast<std::size_t>(square_[at].child + part);
  }
}

bool TakenSpots::touched(std::size_t square, Vec2 at, float radius) const {
  const Square& s = square_[square];
  if (s.child < 0 && s.count == 0) return false;
  // Rounding keeps the order of distances, so what is passed over here would not touch.
  if (glm::distance(at, glm::clamp(at, s.low, s.high)) >= radius + s.widest) return false;
  for (std::int32_t i = s.first; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
    const Spot& other = spot_[static_cast<std::size_t>(i)];
    if (glm::distance(at, other.at) < radius + other.radius) return true;
  }
  for (std::int32_t k = 0; s.child >= 0 && k < 4; ++k)
    if (touched(static_cast<std::size_t>(s.child + k), at, radius)) return true;
  return false;
}

std::vector<Spot> scatter(Vec2 centre, double inner, double outer, float radius, int count, TakenSpots& taken,
                          Seed seed) {
  constexpr int kDartsEach = 60, kPatience = 1000;
  std::vector<Spot> spots;
  for (int i = 0, missed = 0; i < count && missed < kPatience; ++i, ++missed) {
    for (int dart = 0; dart < kDartsEach; ++dart) {
      Seed throw_seed = seed.child(static_cast<std::uint64_t>(i)).child(static_cast<std::uint64_t>(dart));
      double angle = throw_seed.child("angle").range(0, 2 * kPi);
      double distance = std::sqrt(throw_seed.child("distance").range(inner * inner, outer * outer));
      Vec2 at = centre + Vec2(distance * std::cos(angle), distance * std::sin(angle));
      if (!taken.free(at, radius)) continue;
      spots.push_back({at, radius, static_cast<std::uint32_t>(i)});
      taken.add(spots.back());
      missed = -1;
      break;
    }
  }
  return spots;
}

}  // namespace frond
