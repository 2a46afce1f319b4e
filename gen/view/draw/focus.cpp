#include "draw/focus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "draw/surfel_sampler.h"
#include "scene/camera.h"

namespace frond {

namespace {

constexpr float kFocusSpot = 0.02f;   // of half the picture's width, as the spot of an autofocus
constexpr float kBeforeLens = 0.02f;  // metres before the lens
constexpr float kNoDepth = std::numeric_limits<float>::infinity();

/// What is in a spot of the picture: how deep the nearest of it lies.
struct FocusSpot {
  const Lens& lens;
  Vec2 at{0};  // of the picture, -1 to 1
  float& depth;
  std::mutex& in_work;

  float step(Vec3 place) const {
    return kFocusSpot * lens.wide * std::max(glm::distance(place, lens.at), kBeforeLens);
  }
  void add(Vec3 place, float area, Vec3, Facing, float) const {
    Vec3 seen = lens.seen(place);
    if (seen.z < kBeforeLens) return;
    float reach = kFocusSpot + 0.5f * std::sqrt(area) / (lens.wide * seen.z);
    if (std::abs(seen.x - at.x) > reach || std::abs(seen.y - at.y) * lens.high > reach * lens.wide) return;
    std::lock_guard lock(in_work);
    depth = std::min(depth, seen.z);
  }
};

/// The middle of what is before the lens, by area; the same whatever the order in which threads come.
struct FocusMiddle {
  const Lens& lens;
  std::vector<std::pair<Vec3, float>>& bits;
  std::mutex& in_work;

  float step(Vec3 place) const {
    return 4 * kFocusSpot * lens.wide * std::max(glm::distance(place, lens.at), kBeforeLens);
  }
  void add(Vec3 place, float area, Vec3, Facing, float) const {
    if (lens.seen(place).z < kBeforeLens) return;
    std::lock_guard lock(in_work);
    bits.emplace_back(place, area);
  }
};

/// The copies of the named set as balls in their room, of which the one nearest to the axis
/// counts.
std::optional<float> depth_of_copies(const CopySet& set, const Lens& lens, double time) {
  float nearest = kNoDepth, depth = kNoDepth;
  for (std::size_t i = 0; i < set.copies.size(); ++i) {
    if (!set.copies.there(i, time)) continue;
    float half = 0.5f * set.copies.scale_at(i, time).y * static_cast<float>(set.tallest());
    Vec3 seen = lens.seen(set.copies.foot[i] + set.copies.turn_at(i, time) * Vec3(0, half, 0));
    if (seen.z < kBeforeLens) continue;
    float off = std::hypot(seen.x * lens.wide, seen.y * lens.high);
    if (off < nearest) nearest = off, depth = seen.z;
  }
  return depth < kNoDepth ? std::optional(depth) : std::nullopt;
}

std::optional<float> depth_of(const std::vector<std::unique_ptr<DrawList>>& all_drawn, const Lens& lens) {
  std::mutex in_work;
  float depth = kNoDepth;
  auto look = [&](Vec2 at) {
    for (const auto& drawn : all_drawn) sample_surfels(FocusSpot{lens, at, depth, in_work}, *drawn);
    return depth < kNoDepth;
  };
  if (look(Vec2(0))) return depth;
  std::vector<std::pair<Vec3, float>> bits;
  for (const auto& drawn : all_drawn) sample_surfels(FocusMiddle{lens, bits, in_work}, *drawn);
  if (bits.empty()) return std::nullopt;
  std::ranges::sort(bits, [](const auto& a, const auto& b) {
    return std::tie(a.first.x, a.first.y, a.first.z, a.second) <
           std::tie(b.first.x, b.first.y, b.first.z, b.second);
  });
  DVec3 sum(0);
  double all = 0;
  for (const auto& [place, area] : bits) sum += DVec3(place) * double(area), all += area;
  if (!(all > 0)) return std::nullopt;
  Vec3 middle = lens.seen(Vec3(sum / all));
  if (middle.z < kBeforeLens) return std::nullopt;
  if (look(Vec2(middle.x, middle.y))) return depth;
  return middle.z;
}

}  // namespace

std::optional<Vec3> named_focus(const Scene& scene, double time) {
  const Camera& camera = scene.setup.camera;
  if (!camera.aperture || !camera.focus || camera.focus->organism.empty()) return std::nullopt;
  const std::string& name = camera.focus->organism;
  Lens lens = lens_at(camera, time, scene.film.aspect());
  std::vector<std::shared_ptr<const Specimen>> specimens;
  std::vector<std::unique_ptr<DrawList>> drawn;
  for (const Specimen& s : scene.specimens) {
    if (s.name != name) continue;
    auto now = developed(s, time);
    if (!now) continue;
    specimens.push_back(*now);
    drawn.push_back(std::make_unique<DrawList>(**now, time));
  }
  std::optional<float> depth = drawn.empty() ? std::nullopt : depth_of(drawn, lens);
  for (const CopySet& set : scene.copy_sets)
    if (!depth && set.organism.name == name) depth = depth_of_copies(set, lens, time);
  if (!depth) return std::nullopt;
  return lens.at + *depth * lens.toward;
}

Vec3 focus_of(const Camera& camera, double time) {
  bool given = camera.focus && camera.focus->organism.empty();
  return (given ? camera.focus->point : camera.look_at).at(time);
}

double lens_width(const Camera& camera, double time) {
  constexpr double kFilm = 0.036;  // metres, how wide it is
  return camera.aperture ? kFilm / 2 / std::tan(radians(camera.angle.at(time)) / 2) / *camera.aperture : 0;
}

}  // namespace frond
