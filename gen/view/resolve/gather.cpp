#include "resolve/gather.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr float kOnePlane = 0.004f;  // of the distance to the eye, by which places of one surface differ
constexpr float kOneFacing = 0.8f;   // cosine of the angle by which their normals do
constexpr float kNearPlane = 0.01f;  // the same of samples that are taken for it
constexpr float kNearFacing = 0.6f;
constexpr float kNearDepth = 0.05f;  // of the distance, where nothing nearer was found
constexpr float kLeastWeight = 1e-3f;
constexpr int kPasses = 3;
constexpr int kFewSide = 3;  // of the rays that tell whether a pixel shows more than one surface

}  // namespace

SampleGrid::SampleGrid(int width, int height, RowBand band, const std::vector<std::vector<RawSample>>& rows)
    : width_(width), height_(height), band_(band) {
  std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(band.count());
  auto each = [&](const auto& visit) {
    for (const auto& row : rows)
      for (const RawSample& sample : row)
        if (int y = static_cast<int>(sample.place.y); band.holds(y))
          visit(sample, cell(static_cast<int>(sample.place.x), y));
  };
  first_.assign(count + 1, 0);
  each([&](const RawSample&, std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t i = 0; i < count; ++i) first_[i + 1] += first_[i];
  samples_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  each([&](const RawSample& sample, std::size_t cell) { samples_[next[cell]++] = sample; });
}

void Gatherer::add_ray(Vec2 place, int ray, float spread) {
  Vec2 size(grid_.width(), grid_.height());
  auto [from, along] = now_.ray(place / size, ray, spread);
  std::optional<PassHit> hit = now_.trace(from, along);
  // Where the middle of the lens sees it, as raw frames do.
  if (now_.lens > 0)
    if (std::optional<Vec2> seen = picture_place(now_.eye, hit ? hit->at : now_.eye.at + along))
      place = glm::clamp(*seen * size, Vec2(0), size - 0.01f);
  Thing surface = hit ? surface_of(hit->spot.thing) : Thing{};
  bool lit = hit && now_.lit(*hit);
  auto same = [&](const Shown& one) {
    return one.surface == surface && one.lit == lit && glm::ivec2(one.place) == glm::ivec2(place) &&
           (!hit || (glm::dot(one.normal, hit->normal) > kOneFacing &&
                     std::abs(glm::dot(one.normal, hit->at - one.at)) < kOnePlane * hit->away));
  };
  auto found = std::ranges::find_if(shown_, same);
  if (found == shown_.end()) {
    Shown fresh{surface, lit};
    if (hit) fresh.away = hit->away, fresh.at = hit->at, fresh.normal = hit->normal;
    found = shown_.insert(shown_.end(), fresh);
  }
  ++found->rays;
  found->place += (place - found->place) / static_cast<float>(found->rays);
  if (lit) found->facing += (hit->spot.facing - found->facing) / static_cast<float>(found->rays);
}

/// Pixels.
float Gatherer::blur_of(const Shown& one) const {
  Vec3 at = one.surface.kind == ThingKind::nothing ? now_.eye.at + kBackdropAway * now_.eye.ahead : one.at;
  return now_.blur(at) * static_cast<float>(grid_.width());
}

float Gatherer::blur() {
  constexpr float kFew = 0.04f;  // of all rays
  if (now_.lens == 0) return 0;
  float left = 0;
  for (const Shown& one : shown_) left += kFew * static_cast<float>(one.rays);
  std::ranges::sort(shown_, {}, [&](const Shown& one) { return blur_of(one); });
  for (const Shown& one : shown_)
    if (left -= static_cast<float>(one.rays); left < 0) return blur_of(one);
  return 0;
}

void Gatherer::find_shown(int x, int y) {
  shown_.clear();
  Vec2 at(x, y);
  float spread = pixel_spread(at);
  auto add_grid = [&](int side) {
    for (int ray = 0; ray < side * side; ++ray) add_ray(at + place_in_pixel(ray, side), ray, spread);
  };
  add_grid(kFewSide);
  if (shown_.size() > 1) add_grid(options_.side);
  auto blurred = [&](const Shown& one) { return blur_of(one) > 1; };
  if (now_.lens > 0 && std::ranges::any_of(shown_, blurred)) add_grid(2 * options_.side);
}

bool Gatherer::gather(const Shown& one, int pass, Vec3& light) {
  int reach = pass + 1;
  glm::ivec2 cell(one.place);
  auto sigma = static_cast<float>(options_.reach) * static_cast<float>(reach);
  auto takes = [&](const RawSample& s) {
    if (pass == kPasses - 1) return true;
    if (s.surface != one.surface || s.lit != one.lit) return false;
    if (one.surface.kind == ThingKind::nothing) return true;
    if (pass > 0) return std::abs(s.away - one.away) <= kNearDepth * one.away;
    return glm::dot(s.normal, one.normal) >= kNearFacing &&
           std::abs(glm::dot(one.normal, s.at - one.at)) <= kNearPlane * one.away;
  };
  taken_.clear();
  Vec3 mean(0), square(0);
  int count = 0;
  bool clips = options_.clip > 0;
  for (int j = std::max(0, cell.y - reach); j <= std::min(grid_.height() - 1, cell.y + reach); ++j)
    for (int i = std::max(0, cell.x - reach); i <= std::min(grid_.width() - 1, cell.x + reach); ++i)
      for (const RawSample& s : grid_.in(i, j)) {
        if (!takes(s)) continue;
        taken_.push_back(&s);
        if (clips && s.age == 0) {
          Vec3 root = glm::sqrt(s.light);
          mean += root, square += root * root, ++count;
        }
      }
  Vec3 low(0), high(1e9f);
  if (clips && count >= 4) {
    mean /= static_cast<float>(count);
    Vec3 spread = static_cast<float>(options_.clip) *
                      glm::sqrt(glm::max(square / static_cast<float>(count) - mean * mean, Vec3(0))) +
                  0.004f;
    low = glm::max(mean - spread, Vec3(0)), high = mean + spread;
    low *= low, high *= high;
  }
  Vec3 sum(0);
  float weight = 0, facing = 0;
  for (const RawSample* s : taken_) {
    Vec2 aside = s->place - one.place;
    float w = std::exp(-glm::dot(aside, aside) / (2 * sigma * sigma) -
                       static_cast<float>(std::abs(s->age) / options_.fade));
    sum += w * (s->age == 0 ? s->light : glm::clamp(s->light, low, high));
    facing += w * s->facing;
    weight += w;
  }
  if (weight < kLeastWeight) return false;
  light = sum / weight;
  if (one.lit && pass < kPasses - 1) turn_light(one, facing / weight, light);
  return true;
}

/// Round what is narrower than a pixel the light falls from bright to none. What a few samples of it have
/// that face the main light so far is carried to how the surface does, as the light of all around changes
/// with that.
void Gatherer::turn_light(const Shown& one, float facing, Vec3& light) {
  constexpr float kSame = 0.02f;  // cosine
  if (std::abs(one.facing - facing) < kSame) return;
  constexpr int kReach = 3;               // cells
  constexpr float kLeastSpread = 0.004f;  // added to the variance of how samples face the light
  Vec3 mean(0), by_facing(0), least = light, most = light;
  float count = 0, mean_facing = 0, square = 0;
  glm::ivec2 cell(one.place);
  for (int j = std::max(0, cell.y - kReach); j <= std::min(grid_.height() - 1, cell.y + kReach); ++j)
    for (int i = std::max(0, cell.x - kReach); i <= std::min(grid_.width() - 1, cell.x + kReach); ++i)
      for (const RawSample& s : grid_.in(i, j)) {
        if (!s.lit || s.surface != one.surface || std::abs(s.away - one.away) > kNearDepth * one.away)
          continue;
        count += 1;
        mean += s.light, by_facing += s.facing * s.light;
        mean_facing += s.facing, square += s.facing * s.facing;
        least = glm::min(least, s.light), most = glm::max(most, s.light);
      }
  if (count < 3) return;
  mean /= count, mean_facing /= count;
  float spread = std::max(square / count - mean_facing * mean_facing, 0.0f) + kLeastSpread;
  light += (one.facing - facing) / spread * (by_facing / count - mean_facing * mean);
  light = glm::clamp(light, least, most);
}

Vec3 Gatherer::pixel(int x, int y) {
  find_shown(x, y);
  Vec3 sum(0);
  int rays = 0;
  for (const Shown& one : shown_) {
    Vec3 light(0);
    for (int pass = 0; pass < kPasses; ++pass)
      if (gather(one, pass, light)) {
        sum += static_cast<float>(one.rays) * light;
        rays += one.rays;
        break;
      }
  }
  return rays > 0 ? sum / static_cast<float>(rays) : Vec3(0);
}

}  // namespace frond
