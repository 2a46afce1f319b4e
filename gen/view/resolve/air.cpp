#include "resolve/air.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr int kCell = 2;           // pixels
constexpr int kSteps = 12;         // of a way through a cell
constexpr int kAround = 3;         // cells on each side of which the visibility of the sun is a mean
constexpr int kSide = 2;           // kSide * kSide rays a pixel tell how far away what it shows is
constexpr float kFarthest = 6000;  // metres
constexpr float kOfSky = 0.6f;     // of the sky's light, with what the land throws back (by eye, as the next)
constexpr float kOfZenith = 0.2f;  // of that: mist whitens the blue of the sky
constexpr float kOfShade = 0.4f;   // of the haze's, from crowns and walls where they hide the sky
constexpr float kDisc = 0.005f;    // radians, radius of the sun and of the glow at its rim
constexpr float kLikeDepth = 6;    // how soon cells at other distances count for little
constexpr float kSeen = 3.912f;    // losses in the distance of visibility (Koschmieder 1924)

/// An order of the sixteen cells of a block of four by four in which neighbours are far apart (Bayer 1973).
constexpr int kOrder[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

/// How much more light turns by an angle than by others in the mean.
float phase(float cosine, float forward) {
  float g2 = forward * forward;
  return (1 - g2) / std::pow(1 + g2 - 2 * forward * cosine, 1.5f);
}

/// Metres in a metre by which a ray rises or falls, not 0.
double rise_of(Vec3 along) {
  constexpr double kLevel = 1e-5;
  return std::abs(along.y) < kLevel ? kLevel : along.y;
}

}  // namespace

AirLight::AirLight(const SceneSetup& setup, double time, const TracedFrame& frame, std::array<int, 2> size)
    : frame_(frame), size_(size), wide_((size[0] + kCell - 1) / kCell), high_((size[1] + kCell - 1) / kCell) {
  const Air& air = *setup.air;
  loss_ = kSeen / static_cast<float>(air.visibility.at(time));
  level_ = static_cast<float>(air.level), height_ = static_cast<float>(air.height);
  forward_ = static_cast<float>(air.forward);
  Daylight light = drawn_daylight(setup_at(setup, time));
  sun_ = light.sun, sunlight_ = light.sunlight;
  sky_ = kOfSky * glm::mix(light.aside, light.above, kOfZenith), shade_ = kOfShade * light.fog;
  auto wide = static_cast<std::size_t>(wide_);
  visible_.resize(wide * static_cast<std::size_t>(high_)), away_.resize(visible_.size());
  parallel_for(static_cast<std::size_t>(high_), [&](std::size_t y) {
    for (std::size_t x = 0; x < wide; ++x) {
      Vec2 cell(x, y), middle = (cell + 0.5f) * static_cast<float>(kCell) / Vec2(size_[0], size_[1]);
      Vec3 along = picture_ray(frame_.eye, middle);
      Way through = way(along);
      away_[y * wide + x] = std::max(through.metres, 1e-3f);
      visible_[y * wide + x] = visible(through, cell);
    }
  });
}

AirLight::Way AirLight::way(Vec3 along) const {
  std::optional<PassHit> hit = frame_.trace(frame_.eye.at, along);
  float metres = hit ? std::min(hit->away, kFarthest) : kFarthest;
  return {along, metres, passed(along, metres)};
}

double AirLight::column(double height) const {
  double above = height - level_;
  return above < 0 ? above : height_ * (1 - std::exp(-above / height_));
}

float AirLight::passed(Vec3 along, float metres) const {
  double from = frame_.eye.at.y, rise = rise_of(along);
  return static_cast<float>(std::exp(-loss_ * (column(from + rise * metres) - column(from)) / rise));
}

float AirLight::reached(Vec3 along, float passed) const {
  double from = frame_.eye.at.y, rise = rise_of(along);
  double to = column(from) - rise * std::log(passed) / loss_;
  double above = to < 0 ? to : -height_ * std::log(std::max(1e-9, 1 - to / height_));
  return static_cast<float>((level_ + above - from) / rise);
}

Vec2 AirLight::visible(const Way& way, Vec2 cell) const {
  auto x = static_cast<unsigned>(cell.x), y = static_cast<unsigned>(cell.y);
  float offset = (static_cast<float>(kOrder[y % 4 * 4 + x % 4]) + 0.5f) / 16;
  Vec3 aside = glm::normalize(glm::cross(sun_, reference_axis(sun_)));
  Vec3 up = glm::cross(aside, sun_);
  Vec2 seen(0);
  for (int step = 0; step < kSteps; ++step) {
    auto number = static_cast<float>(step);
    // Each step is as much of the light that is scattered.
    float share = (number + offset) / kSteps;
    float metres = std::clamp(reached(way.along, 1 - share * (1 - way.passed)), 0.0f, way.metres);
    Vec3 at = frame_.eye.at + metres * way.along;
    float turn = 2 * static_cast<float>(kPi) * glm::fract(0.618034f * number + offset);
    float part = glm::fract(0.754878f * number + 0.5f * offset);
    Vec2 round(std::cos(turn), std::sin(turn));
    Vec2 out = kDisc * std::sqrt(part) * round;
    seen.x += frame_.open(at, glm::normalize(sun_ + out.x * aside + out.y * up));
    Vec2 flat = std::sqrt(1 - part * part) * round;  // evenly over the sky
    seen.y += frame_.open(at, {flat.x, part, flat.y});
  }
  return seen / static_cast<float>(kSteps);
}

Vec2 AirLight::visible_at(Vec2 pixel, float metres) const {
  Vec2 place = (pixel + 0.5f) / static_cast<float>(kCell) - 0.5f;
  int x = static_cast<int>(std::lround(place.x)), y = static_cast<int>(std::lround(place.y));
  Vec2 sum(0);
  float all = 0;
  for (int v = std::max(0, y - kAround); v <= std::min(high_ - 1, y + kAround); ++v)
    for (int u = std::max(0, x - kAround); u <= std::min(wide_ - 1, x + kAround); ++u) {
      auto i = static_cast<std::size_t>(v) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(u);
      Vec2 off = (Vec2(u, v) - place) / static_cast<float>(kAround);
      float deep = kLikeDepth * std::log(away_[i] / metres);
      float weight = std::exp(-1.5f * glm::dot(off, off) - deep * deep) + 1e-6f;
      sum += weight * visible_[i], all += weight;
    }
  return sum / all;
}

void AirLight::add(LightPicture& rows, int first) const {
  auto wide = static_cast<std::size_t>(size_[0]);
  Vec2 size(size_[0], size_[1]);
  parallel_for(rows.size() / wide, [&](std::size_t row) {
    for (std::size_t x = 0; x < wide; ++x) {
      Vec2 pixel(x, static_cast<std::size_t>(first) + row);
      float passed = 0;
      Vec3 scattered(0);
      for (int ray = 0; ray < kSide * kSide; ++ray) {
        Vec3 along = picture_ray(frame_.eye, (pixel + place_in_pixel(ray, kSide)) / size);
        Way through = way(along);
        Vec3 sun = phase(glm::dot(along, sun_), forward_) / 4 * sunlight_;
        Vec2 visible = visible_at(pixel, std::max(through.metres, 1e-3f));
        passed += through.passed;
        scattered += (1 - through.passed) * (visible.x * sun + glm::mix(shade_, sky_, visible.y));
      }
      Vec3& light = rows[row * wide + x];
      light = (passed * light + scattered) / static_cast<float>(kSide * kSide);
    }
  });
}

}  // namespace frond
