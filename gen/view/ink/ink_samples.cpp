#include <cmath>

#include "core/parallel.h"
#include "ink/ink.h"

namespace frond {

namespace {

constexpr float kLeast = 1e-9f;

/// Directions whose planes cut a thing in the lines of its hatching, and across these.
const std::array<Vec3, 2> kPlanes{glm::normalize(Vec3(0.3f, 1, 0.2f)),
                                  glm::normalize(Vec3(1, 0.35f, -0.55f))};

/// Makes the samples of one picture.
class InkTracer {
 public:
  InkTracer(const TracedFrame& frame, float metres)
      : frame_(frame),
        metres_(metres),
        right_(glm::cross(frame.eye.ahead, frame.eye.up)),
        light_(glm::normalize(-0.55f * right_ + 0.7f * frame.eye.up - 0.5f * frame.eye.ahead)),
        diagonal_(glm::normalize(right_ + frame.eye.up)) {}

  InkSample sample(Vec2 place) const {
    Vec3 along = picture_ray(frame_.eye, place);
    std::optional<PassHit> hit = grown(frame_.eye.at, along);
    InkSample made;
    if (!hit) return made;
    made.at = hit->at, made.normal = hit->normal;
    made.depth = glm::dot(hit->at - frame_.eye.at, frame_.eye.ahead);
    const Thing& thing = hit->spot.thing;
    made.thing = 1 + ((static_cast<std::uint32_t>(thing.kind) * 73856093u) ^ (thing.owner * 19349663u) ^
                      (thing.number * 83492791u)) %
                         0xfffffffeu;
    made.shade = shade(*hit);
    made.across = glm::dot(hit->at, diagonal_);
    for (std::size_t layer = 0; layer < 2; ++layer) hatch(*hit, along, layer, made);
    return made;
  }

 private:
  /// What grows or stands where a ray leads, through what lies on the ground; none where that is the ground.
  std::optional<PassHit> grown(Vec3 from, Vec3 along) const {
    constexpr int kMost = 64;  // blades of grass, one behind the other
    for (int i = 0; i < kMost; ++i) {
      std::optional<PassHit> hit = frame_.trace(from, along);
      if (!hit || hit->spot.thing.kind == ThingKind::floor) return std::nullopt;
      if (hit->spot.thing.kind < ThingKind::floor) {
        hit->away = glm::distance(hit->at, frame_.eye.at);
        return hit;
      }
      from = hit->at + 1e-4f * std::max(1.0f, glm::distance(hit->at, frame_.eye.at)) * along;
    }
    return std::nullopt;
  }

  float shade(const PassHit& hit) const {
    float facing = std::max(glm::dot(hit.normal, light_), 0.0f);
    float clear = 1e-3f * std::max(hit.away, 0.1f);
    bool shadowed = facing > 0 && frame_.trace(hit.at + clear * hit.normal, light_).has_value();
    return 1 - (shadowed ? 0.3f : 1.0f) * (0.15f + 0.85f * facing);
  }

  void hatch(const PassHit& hit, Vec3 view, std::size_t layer, InkSample& made) const {
    Vec3 gradient(0);
    bool branch =
        hit.spot.thing.kind == ThingKind::branches && layer == 0 && along_branch(hit, made, gradient);
    if (!branch && in_own_axes(hit)) {
      // Each metre of its own axes is so much in the world.
      SurfaceSpot spot = hit.spot;
      PlaceNormal here = frame_.where(spot).value_or(PlaceNormal{hit.at, hit.normal});
      float step = std::max(glm::length(spot.own), 1e-3f);
      spot.own += step * kPlanes[layer];
      PlaceNormal there =
          frame_.where(spot).value_or(PlaceNormal{hit.at + step * kPlanes[layer], hit.normal});
      Vec3 moved = there.at - here.at;
      float scale = glm::length(moved) / step;
      made.phase[layer] = glm::dot(hit.spot.own, kPlanes[layer]) * scale;
      gradient = moved / std::max(glm::length(moved), kLeast);
    } else if (!branch) {
      made.phase[layer] = glm::dot(hit.at, kPlanes[layer]);
      gradient = kPlanes[layer];
    }
    // What a step of a pixel aside on the picture is on the surface.
    float facing = glm::dot(hit.normal, view);
    facing = facing > -0.15f ? -0.15f : facing;
    Vec3 on_picture = gradient - hit.normal * (glm::dot(gradient, view) / facing);
    on_picture -= view * glm::dot(on_picture, view);
    made.slope[layer] = std::max(glm::length(on_picture) * metres_ * hit.away, kLeast);
  }

  /// Whether its spot is told in axes of its own.
  static bool in_own_axes(const PassHit& hit) {
    using enum ThingKind;
    Vec3 own = hit.spot.own;
    bool shares = own.z == 0 && own.x >= 0 && own.y >= 0 && own.x + own.y <= 1.0001f;
    return (hit.spot.thing.kind == organ || hit.spot.thing.kind == copy) && !shares;
  }

  /// The angle round the branch times a radius that holds all along it; false where it has no axis.
  bool along_branch(const PassHit& hit, InkSample& made, Vec3& gradient) const {
    SurfaceSpot foot = hit.spot, head = hit.spot, axis = hit.spot;
    foot.along = 0, head.along = 1, axis.own = Vec3(0);
    auto low = frame_.where(foot), high = frame_.where(head), middle = frame_.where(axis);
    if (hit.spot.along < 0 || !low || !high || !middle) return false;
    Vec3 ahead = high->at - low->at, aside = hit.at - middle->at;
    float length = glm::length(ahead), radius = glm::length(aside);
    if (length < kLeast || radius < kLeast) return false;
    ahead /= length;
    Vec3 across = glm::cross(ahead, std::abs(ahead.z) < 0.9f ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
    Vec3 own = hit.spot.own;
    across = glm::normalize(across);
    float angle = std::atan2(glm::dot(own, glm::cross(ahead, across)), glm::dot(own, across));
    constexpr float kTurns = 0.15915494f;  // of a radian
    made.phase[0] = angle * kTurns;
    gradient = glm::cross(ahead, aside / radius) * (kTurns / radius);
    return true;
  }

  const TracedFrame& frame_;
  float metres_;
  Vec3 right_, light_, diagonal_;
};

}  // namespace

InkSamples ink_samples(const TracedFrame& frame, int width, int height, int fine) {
  InkSamples made{
      width, height, fine, static_cast<float>(2 * frame.eye.broad) / static_cast<float>(width), {}};
  int columns = width * fine, rows = height * fine;
  made.samples.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  InkTracer tracer(frame, made.metres);
  parallel_for(static_cast<std::size_t>(rows), [&](std::size_t y) {
    for (int x = 0; x < columns; ++x)
      made.samples[y * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)] =
          tracer.sample(Vec2((static_cast<float>(x) + 0.5f) / static_cast<float>(columns),
                             (static_cast<float>(y) + 0.5f) / static_cast<float>(rows)));
  });
  return made;
}

}  // namespace frond
