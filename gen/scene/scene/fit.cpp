#include "scene/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/camera.h"

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

/// The place nearest to the points from which all of them are between the four planes that bound the view.
View filled(Vec3 toward, const std::vector<Vec3>& points, double wide, double high) {
  DVec3 f = glm::normalize(DVec3(toward));
  DVec3 up = sky_axis(f);
  DVec3 r = glm::normalize(glm::cross(f, up)), u = glm::cross(r, f);
  double right = farthest(points, r - wide * f), left = farthest(points, -r - wide * f);
  double top = farthest(points, u - high * f), bottom = farthest(points, -u - high * f);
  double along = std::min(-(right + left) / (2 * wide), -(top + bottom) / (2 * high));
  return {Vec3(along * f + (right - left) / 2 * r + (top - bottom) / 2 * u), Vec3(f)};
}

/// The view of all points from a given height: how far back the camera stands is found by halving, and it
/// turns to their middle.
View filled_from(double height, Vec3 toward, const std::vector<Vec3>& points, double wide, double high) {
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
    return glm::dot(filled(v.toward, points, wide, high).at - v.at, v.toward) >= 0;
  };
  double near = 0, far = 1;
  while (!holds(view(far)) && far < kFarthest) near = far, far *= 2;
  for (int i = 0; i < 40; ++i) (holds(view((near + far) / 2)) ? far : near) = (near + far) / 2;
  return view(far);
}

}  // namespace

std::vector<Vec3> outside_of(const Model& model) {
  Outside outside;
  add(outside, model);
  return outside.points();
}

std::vector<Vec3> outside_of(const Scene& scene, const std::vector<std::string>& names) {
  std::set<std::string_view> wanted(names.begin(), names.end());
  bool all = wanted.contains(kFitAll);
  Outside outside;
  for (const Specimen& s : scene.specimens)
    if (s.entry != Traits::kNoEntry && (all || wanted.contains(s.name))) add(outside, s.model);
  for (const CopySet& set : scene.copy_sets) {
    if (!all && !wanted.contains(set.organism.name)) continue;
    for (std::size_t i = 0; i < set.copies.size(); ++i) {
      float scale = set.copies.scale[i], wide = scale * static_cast<float>(set.organism.sown->where.radius),
            tall = scale * static_cast<float>(set.tallest());
      outside.add(set.copies.foot[i]);
      outside.add(set.copies.foot[i] + Vec3(0, std::max(tall - wide, 0.0f), 0), wide);
    }
  }
  return outside.points();
}

Camera fitted(const Camera& camera, const std::vector<Vec3>& points, double aspect, const Heights& heights) {
  if (points.empty()) return camera;
  std::set<double> times;
  for (const auto* path : {&camera.location, &camera.look_at})
    for (const auto& key : path->keys()) times.insert(key.time);
  for (const auto& key : camera.angle.keys()) times.insert(key.time);
  std::vector<Animated<Vec3>::Key> location, look_at;
  for (double time : times) {
    Vec3 toward = glm::normalize(camera.look_at.at(time) - camera.location.at(time));
    double wide = (1 - 2 * camera.margin) * std::tan(radians(camera.angle.at(time)) / 2);
    View view = filled(toward, points, wide, aspect * wide);
    double ground = heights(view.at.x, view.at.z) + kEyeLevel;
    if (view.at.y < ground && std::abs(toward.y) < 0.999f)
      view = filled_from(std::max(ground, static_cast<double>(std::min(camera.location.at(time).y, 2.0f))),
                         toward, points, wide, aspect * wide);
    double deep = -std::numeric_limits<double>::infinity(), near = -deep;
    for (const Vec3& p : points) {
      double depth = glm::dot(p - view.at, view.toward);
      deep = std::max(deep, depth), near = std::min(near, depth);
    }
    location.push_back({time, view.at});
    look_at.push_back({time, view.at + static_cast<float>(std::max((deep + near) / 2, 0.01)) * view.toward});
  }
  Camera moved = camera;
  moved.location = Animated<Vec3>(std::move(location));
  moved.look_at = Animated<Vec3>(std::move(look_at));
  return moved;
}

}  // namespace frond
