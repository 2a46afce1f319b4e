#include "scene/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/bounds.h"
#include "scene/copies.h"

namespace frond {

namespace {

constexpr std::size_t kDirections = 256;
constexpr double kEyeLevel = 0.12;  // metres that the lens is above the ground at least
constexpr double kFarthest = 1000;  // metres, as a location may be

/// The outermost of points and balls in each of many directions.
class Outside {
 public:
  Outside() {
    for (std::size_t i = 0; i < kDirections; ++i) {  // even on the sphere, along a spiral
      double y = 1 - 2 * (static_cast<double>(i) + 0.5) / kDirections, flat = std::sqrt(1 - y * y);
      double turn = kPi * (3 - std::sqrt(5.0)) * static_cast<double>(i);
      toward_[i] = Vec3(flat * std::cos(turn), y, flat * std::sin(turn));
    }
    reach_.fill(-std::numeric_limits<float>::infinity());
  }

  void add(Vec3 p, float radius = 0) {
    for (std::size_t i = 0; i < kDirections; ++i)
      if (float reach = glm::dot(p, toward_[i]) + radius; reach > reach_[i])
        reach_[i] = reach, point_[i] = p + radius * toward_[i];
  }

  /// Whether anything of a ball may be outermost.
  bool may_hold(Vec3 p, float radius) const {
    for (std::size_t i = 0; i < kDirections; ++i)
      if (glm::dot(p, toward_[i]) + radius > reach_[i]) return true;
    return false;
  }

  std::vector<Vec3> points() const {
    std::vector<Vec3> list;
    for (std::size_t i = 0; i < kDirections; ++i)
      if (std::isfinite(reach_[i])) list.push_back(point_[i]);
    return list;
  }

 private:
  std::array<Vec3, kDirections> toward_, point_;
  std::array<float, kDirections> reach_;
};

/// The corners of what an organ is, from its foot.
std::vector<Vec3> corners_of(const Prototype& organ) {
  std::vector<Vec3> corners;
  for (const OrganPart& part : organ.parts)
    corners.insert(corners.end(), part.surface.position.begin(), part.surface.position.end());
  return corners;
}

void add(Outside& outside, const Model& m) {
  for (std::size_t i = 0; i < m.skeleton.size(); ++i)
    outside.add(m.skeleton.position[i], m.skeleton.radius[i]);
  std::vector<std::vector<Vec3>> corners;
  std::vector<float> size;
  for (const Prototype& organ : m.prototypes)
    corners.push_back(corners_of(organ)), size.push_back(reach_of(organ));
  for (std::size_t i = 0; i < m.organs.size(); ++i) {
    Vec3 at = m.organs.position[i], scale = m.organs.scale[i];
    std::size_t which = m.organs.prototype[i];
    if (!outside.may_hold(at, std::max({scale.x, scale.y, scale.z}) * size[which])) continue;
    for (const Vec3& p : corners[which]) outside.add(at + m.organs.turn[i] * (scale * p));
  }
  for (const Vec3& p : m.blades.surface.position) outside.add(p);
  std::vector<Bounds> boxes;
  for (const Solid& solid : m.solids.shapes) boxes.push_back(bounds_of(solid.surface.position));
  for (std::size_t i = 0; i < m.solids.size(); ++i) {
    const Bounds& box = boxes[m.solids.shape[i]];
    Vec3 middle = 0.5f * (box.low + box.high), wide = m.solids.scale[i] * (box.high - box.low);
    constexpr float kRoom = 0.51f;  // of its diagonal round its middle, with what rounding may take
    if (!outside.may_hold(m.solids.placed(i, middle), kRoom * glm::length(wide))) continue;
    for (const Vec3& p : m.solids.shapes[m.solids.shape[i]].surface.position)
      outside.add(m.solids.placed(i, p));
  }
}

struct View {
  Vec3 at{0}, toward{0, 0, -1};
};

/// The greatest of `n . p`.
double farthest(const std::vector<Vec3>& points, DVec3 n) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : points) most = std::max(most, glm::dot(n, DVec3(p)));
  return most;
}

/// A part of the picture: tangents of the angles to its edges.
struct Window {
  double left, right, bottom, top;
  Window(double wide, double high) : left(-wide), right(wide), bottom(-high), top(high) {}
};

/// The place nearest to the points from which all of them are between the four planes that bound the window.
View filled(Vec3 toward, const std::vector<Vec3>& points, const Window& w) {
  DVec3 f = glm::normalize(DVec3(toward));
  DVec3 up = sky_axis(f);
  DVec3 r = glm::normalize(glm::cross(f, up)), u = glm::cross(r, f);
  double right = farthest(points, r - w.right * f), left = farthest(points, -r + w.left * f);
  double top = farthest(points, u - w.top * f), bottom = farthest(points, -u + w.bottom * f);
  double along = std::min(-(right + left) / (w.right - w.left), -(top + bottom) / (w.top - w.bottom));
  double aside = (right - left) / 2 + (w.right + w.left) / 2 * along,
         above = (top - bottom) / 2 + (w.top + w.bottom) / 2 * along;
  return {Vec3(along * f + aside * r + above * u), Vec3(f)};
}

/// The view of all points from a given height: how far back the camera stands is found by halving, and it
/// turns to their middle.
View filled_from(double height, Vec3 toward, const std::vector<Vec3>& points, const Window& window) {
  DVec3 middle(0);
  for (const Vec3& p : points) middle += DVec3(p) / static_cast<double>(points.size());
  DVec3 back = glm::normalize(DVec3(-toward.x, 0, -toward.z));
  auto view = [&](double away) {
    DVec3 at = DVec3(middle.x, height, middle.z) + away * back;
    double low = kPi / 2, top = -kPi / 2;
    for (const Vec3& p : points) {
      double slope = std::atan2(p.y - at.y, std::max(1e-6, glm::dot(DVec3(p) - at, -back)));
      low = std::min(low, slope), top = std::max(top, slope);
    }
    double pitch = (low + top) / 2;
    return View{Vec3(at), Vec3(-std::cos(pitch) * back + DVec3(0, std::sin(pitch), 0))};
  };
  auto holds = [&](const View& v) {
    // How far it would step back: no farther.
    return glm::dot(filled(v.toward, points, window).at - v.at, v.toward) >= 0;
  };
  double near = 0, far = 1;
  while (!holds(view(far)) && far < kFarthest) near = far, far *= 2;
  for (int i = 0; i < 40; ++i) (holds(view((near + far) / 2)) ? far : near) = (near + far) / 2;
  return view(far);
}

/// The part of the picture that a subject is given.
Window window_of(const Composition& c, double wide, double high) {
  constexpr double kThird = 1.0 / 3,
                   kHalf = 0.56;  // of half the width: its middle, and half of what it fills
  Window w(wide, high);
  w.top = (1 - 2 * c.headroom) * high;
  w.bottom = std::min(2 * c.foreground - 1, 0.9 - 2 * c.headroom) * high;
  if (c.third == Third::middle) return w.left *= 0.85, w.right *= 0.85, w;
  double middle = c.third == Third::left ? -kThird : kThird;
  w.left = (middle - kHalf) * wide, w.right = (middle + kHalf) * wide;
  return w;
}

/// Radians, about the vertical, by which a view is turned for the light.
double turn_to_light(const Composition& c, Vec3 toward, Vec3 sun) {
  constexpr double kOffSun[] = {0, radians(40.0), radians(80.0),
                                radians(140.0)};  // from where the camera looks
  if (c.light == LightSide::as_it_is || std::hypot(sun.x, sun.z) < 1e-3) return 0;
  double now = std::atan2(toward.x, toward.z), off = kOffSun[static_cast<std::size_t>(c.light)];
  double to_sun = std::atan2(sun.x, sun.z) - now;
  double left = std::remainder(to_sun - off, 2 * kPi), right = std::remainder(to_sun + off, 2 * kPi);
  if (c.third == Third::middle) return std::abs(left) < std::abs(right) ? left : right;
  return c.third == Third::right ? left : right;
}

/// The view of all points in a window from so high above the ground: the more it looks up, the lower it
/// stands.
View composed(const Composition& c, Vec3 toward, const std::vector<Vec3>& points, const Window& window,
              const Heights& heights) {
  double azimuth = std::atan2(toward.x, toward.z), down = radians(-80.0), up = radians(70.0);
  auto view = [&](double pitch) {
    return filled(Vec3(DVec3(std::sin(azimuth) * std::cos(pitch), std::sin(pitch),
                             std::cos(azimuth) * std::cos(pitch))),
                  points, window);
  };
  for (int i = 0; i < 40; ++i) {
    double middle = (down + up) / 2;
    View v = view(middle);
    (v.at.y > heights(v.at.x, v.at.z) + c.height ? down : up) = middle;
  }
  return view(down);
}

/// Whether an organism of that name is among those named, or all are.
bool is_named(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::any_of(names, [&](const std::string& one) { return one == kFitAll || one == name; });
}

/// The specimens of entries of these names, or all.
std::vector<const Specimen*> named(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<const Specimen*> list;
  for (const Specimen& s : scene.specimens)
    if (s.entry != Traits::kNoEntry && is_named(names, s.name)) list.push_back(&s);
  return list;
}

}  // namespace

std::vector<Vec3> outside_of(const Model& model) {
  Outside outside;
  add(outside, model);
  return outside.points();
}

std::vector<Vec3> outside_of(const Scene& scene, const std::vector<std::string>& names) {
  Outside outside;
  for (const Specimen* s : named(scene, names)) add(outside, s->model);
  for (const CopySet& set : scene.copy_sets) {
    if (!is_named(names, set.organism.name)) continue;
    for (std::size_t i = 0; i < set.copies.size(); ++i) {
      float scale = set.copies.scale[i], wide = scale * static_cast<float>(set.organism.sown->where.radius),
            tall = scale * static_cast<float>(set.tallest());
      outside.add(set.copies.foot[i]);
      outside.add(set.copies.foot[i] + Vec3(0, std::max(tall - wide, 0.0f), 0), wide);
    }
  }
  return outside.points();
}

std::vector<std::string> organ_names(const Scene& scene, const std::vector<std::string>& names) {
  std::set<std::string> all;
  for (const Specimen* s : named(scene, names))
    for (std::uint16_t which : s->model.organs.prototype) all.insert(s->model.prototypes[which].name);
  return {all.begin(), all.end()};
}

namespace {

/// Of the organs of one name the one that shows best from an eye: of the large ones the nearest.
class BestOrgan {
 public:
  BestOrgan(std::string_view name, Vec3 eye) : name_(name), eye_(eye) {}

  /// Those of a model that stands there.
  void add(const Model& m, Vec3 foot, Quat turn, float scale) {
    constexpr float kLarge = 0.75f;  // of the largest
    const Organs& o = m.organs;
    auto is_one = [&](std::size_t i) { return m.prototypes[o.prototype[i]].name == name_; };
    float largest = 0;
    for (std::size_t i = 0; i < o.size(); ++i)
      if (is_one(i)) largest = std::max(largest, glm::length(o.scale[i]));
    for (std::size_t i = 0; i < o.size(); ++i) {
      const float away = glm::distance(foot + turn * (scale * o.position[i]), eye_);
      if (!is_one(i) || glm::length(o.scale[i]) < kLarge * largest || away >= nearest_) continue;
      nearest_ = away;
      points_.clear();
      // Pieces of one flower share their number.
      for (std::size_t k = i; k < o.size() && o.id[k] == o.id[i]; ++k)
        for (const Vec3& p : corners_of(m.prototypes[o.prototype[k]]))
          points_.push_back(foot + turn * (scale * (o.position[k] + o.turn[k] * (o.scale[k] * p))));
    }
  }

  bool is_found() const { return !points_.empty(); }

  /// Points on its outside, with as much room round it as it is wide.
  std::vector<Vec3> points() const {
    std::vector<Vec3> wider = points_;
    const Vec3 middle = bounds_of(points_).middle();
    for (Vec3& p : wider) p += p - middle;
    return wider;
  }

 private:
  std::string_view name_;
  Vec3 eye_;
  std::vector<Vec3> points_;
  float nearest_ = std::numeric_limits<float>::infinity();
};

}  // namespace

std::vector<Vec3> outside_of_part(const Scene& scene, const std::vector<std::string>& names,
                                  std::string_view part) {
  const Vec3 eye = scene.setup.camera.location.at(0);
  BestOrgan best(part, eye);
  for (const Specimen* grown : named(scene, names)) {
    const auto now = developed(*grown, 0);
    best.add(now ? (*now)->model : grown->model, Vec3(0), Quat(1, 0, 0, 0), 1);
  }
  for (const CopySet& set : scene.copy_sets) {
    const Copies& copies = set.copies;
    if (copies.size() == 0 || !is_named(names, set.organism.name)) continue;
    // Of each model the nearest copy, until one of them bears it.
    std::map<std::size_t, std::size_t> nearest;
    const auto away = [&](std::size_t i) { return glm::distance(copies.foot[i], eye); };
    for (std::size_t i = 0; i < copies.size(); ++i)
      if (auto [known, is_new] = nearest.try_emplace(copies.model[i], i);
          !is_new && away(i) < away(known->second))
        known->second = i;
    std::vector<std::size_t> order;
    for (const auto& [model, copy] : nearest) order.push_back(copy);
    std::ranges::sort(order, {}, away);
    for (std::size_t i : order) {
      if (Result<Model> model = grow_copy(set.organism, copies.model[i]))
        best.add(*model, copies.foot[i], copies.turn[i], copies.scale[i]);
      if (best.is_found()) break;
    }
  }
  return best.points();
}

Camera fitted(const Camera& camera, const std::vector<Vec3>& points, double aspect, const Heights& heights,
              Vec3 sun) {
  if (points.empty()) return camera;
  std::set<double> times;
  for (const auto* path : {&camera.location, &camera.look_at})
    for (const auto& key : path->keys()) times.insert(key.time);
  for (const auto& key : camera.angle.keys()) times.insert(key.time);
  std::vector<Animated<Vec3>::Key> location, look_at;
  Vec3 first = camera.look_at.at(0) - camera.location.at(0);
  Quat turn = camera.compose ? glm::angleAxis(static_cast<float>(turn_to_light(*camera.compose, first, sun)),
                                              Vec3(0, 1, 0))
                             : Quat(1, 0, 0, 0);
  for (double time : times) {
    Vec3 toward = glm::normalize(camera.look_at.at(time) - camera.location.at(time));
    double half = std::tan(radians(camera.angle.at(time)) / 2), wide = (1 - 2 * camera.margin) * half;
    View view = camera.compose ? composed(*camera.compose, turn * toward, points,
                                          window_of(*camera.compose, half, aspect * half), heights)
                               : filled(toward, points, {wide, aspect * wide});
    double ground = heights(view.at.x, view.at.z) + kEyeLevel;
    if (!camera.compose && view.at.y < ground && std::abs(toward.y) < 0.999f)
      view = filled_from(std::max(ground, static_cast<double>(std::min(camera.location.at(time).y, 2.0f))),
                         toward, points, {wide, aspect * wide});
    double deep = -std::numeric_limits<double>::infinity(), near = -deep;
    for (const Vec3& p : points) {
      double depth = glm::dot(p - view.at, view.toward);
      deep = std::max(deep, depth), near = std::min(near, depth);
    }
    location.push_back({time, view.at});
    look_at.push_back({time, view.at + static_cast<float>(std::max((deep + near) / 2, 0.01)) * view.toward});
  }
  Camera moved = camera;
  moved.compose.reset();
  if (!camera.part.empty()) {
    constexpr double kCloseUp = 11;  // f-number, as one stops down for a flower
    moved.focus.reset();
    if (moved.aperture) moved.aperture = std::max(*moved.aperture, kCloseUp);
  }
  moved.location = Animated<Vec3>(std::move(location));
  moved.look_at = Animated<Vec3>(std::move(look_at));
  return moved;
}

}  // namespace frond
