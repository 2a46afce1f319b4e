#include "world/obstacles.h"

#include <algorithm>

#include "creeping/soup.h"
#include "model/surface.h"

namespace frond {

namespace {

constexpr int kTries = 5;              // corners that a limb may meet at once
constexpr double kHeadOn = 0.97;       // cosine to the surface's normal: what meets it so turns upward
constexpr double kShortest = 0.3;      // share of its length that a limb keeps
constexpr double kSteepestRise = 0.5;  // by what share of its length it may move away from a surface
constexpr double kSlack = 1e-5;        // metres

/// Along the surface with that normal: the direction without what leads into it, or upward.
DVec3 along_surface(DVec3 direction, DVec3 normal) {
  if (glm::dot(direction, normal) < -kHeadOn) direction = DVec3(0, 1, 0);
  DVec3 flat = direction - normal * glm::dot(direction, normal);
  double length = glm::length(flat);
  return length > 0.1 ? flat / length : DVec3(0);
}

}  // namespace

Result<Obstacles> Obstacles::build(std::span<const Surface> bodies) {
  Obstacles obstacles;
  Surface all;
  for (const Surface& body : bodies) {
    if (body.triangle.empty()) continue;
    append(all, body);
    obstacles.boxes_.push_back(bounds_of(body.position));
  }
  if (all.triangle.empty()) return obstacles;
  Result<TriangleSurface> host = TriangleSurface::build(all, "the bodies that branches bend round");
  if (!host && mend_surface(all).corners.empty()) return Obstacles();
  if (!host) return host.errors();
  obstacles.host_ = std::make_shared<const TriangleSurface>(std::move(*host));
  return obstacles;
}

bool Obstacles::near(const Bounds& box) const {
  return host_ && std::ranges::any_of(boxes_, [&](const Bounds& body) {
           return glm::all(glm::lessThanEqual(box.low, body.high)) &&
                  glm::all(glm::lessThanEqual(body.low, box.high));
         });
}

std::optional<Vec3> Obstacles::way(Vec3 from, Vec3 to, float clearance) const {
  Bounds box;
  box.extend(from, clearance), box.extend(to, clearance);
  if (!near(box)) return to;
  DVec3 start(from), end(to);
  double length = glm::distance(start, end);
  if (host_->inside(start)) return length > 0 ? std::optional(to) : std::nullopt;
  if (length == 0) return to;
  auto beginning = host_->closest(start, clearance);
  double room = beginning ? beginning->distance : clearance;
  double keep = std::min<double>(clearance, room + kSteepestRise * length);
  for (int i = 0; i < kTries; ++i) {
    auto hit = host_->crossing(start, end);
    auto contact = host_->closest(end, keep);
    if (!hit && (!contact || contact->distance > keep - kSlack)) return i == 0 ? to : Vec3(end);
    // Where it only comes too near the surface is beside its end, else where it would go through.
    DVec3 normal = hit ? hit->normal : contact->normal;
    DVec3 way = (end - start) / length;
    if (hit && glm::dot(normal, way) > 0) normal = -normal;
    if (DVec3 aside = along_surface(way, normal); glm::dot(way, normal) < 0) end = start + aside * length;
    if (auto side = host_->closest(end, keep);
        side && !host_->crossing(start, side->point + side->normal * keep))
      end = side->point + side->normal * keep;
    if (glm::distance(start, end) < kShortest * length) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace frond
