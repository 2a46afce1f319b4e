#include "creeping/tendril_lines.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace frond {

namespace {

constexpr int kTurnNodes = 12;   // of a turn of a free coil
constexpr int kRoundNodes = 16;  // of a turn round a pole

/// How far it is from within a host to its surface; `most` where that is farther.
double room(const TriangleSurface& host, const DVec3& from, const DVec3& direction, double most) {
  std::optional<Crossing> out = host.crossing(from, from + most * direction);
  return out ? out->share * most : most;
}

}  // namespace

std::vector<DVec3> coiled_line(const DVec3& from, const DVec3& bend, const DVec3& to, double coils,
                               double radius) {
  constexpr int kUncoiledNodes = 10;
  constexpr double kReversal = 0.06;         // half of the share in which the hand changes
  constexpr double kFoot = 0.1, kEnd = 0.9;  // shares of the line between which it is coiled
  DVec3 chord = to - from;
  double length = glm::length(chord);
  bool coiled = radius > 0 && coils > 0 && length > 0;
  int last = coiled ? std::max(kUncoiledNodes, static_cast<int>(std::ceil(2.4 * kTurnNodes * coils)))
                    : kUncoiledNodes;
  DVec3 along = length > 0 ? chord / length : DVec3(0, 1, 0);
  DVec3 one = glm::normalize(glm::cross(along, reference_axis(along))), other = glm::cross(along, one);
  std::vector<DVec3> line;
  for (int i = 0; i <= last; ++i) {
    double t = static_cast<double>(i) / last;
    DVec3 at = (1 - t) * (1 - t) * from + 2 * t * (1 - t) * bend + t * t * to;
    double share = std::clamp((t - kFoot) / (kEnd - kFoot), 0.0, 1.0), side = 2 * share - 1;
    if (coiled) {
      // The angle rises to the middle and falls again, so that it is the same at both ends.
      double most = std::sqrt(1 + kReversal * kReversal);
      double angle = 2 * kPi * coils * (most - std::sqrt(side * side + kReversal * kReversal));
      double wide = radius * smooth_step(0.0, 0.15, share) * smooth_step(0.0, 0.15, 1 - share);
      at += wide * (std::cos(angle) * one + std::sin(angle) * other);
    }
    line.push_back(at);
  }
  return line;
}

std::optional<Pole> pole_at(const TriangleSurface& host, const DVec3& place, const DVec3& normal,
                            double thickest) {
  constexpr int kDirections = 12;
  constexpr double kSkin = 1e-5;    // metres by which rays begin below the surface
  constexpr double kLongest = 4.0;  // of the thickest: what is longer counts as that long
  double thick = room(host, place - kSkin * normal, -normal, 1.01 * thickest) + kSkin;
  if (thick > thickest) return std::nullopt;
  DVec3 middle = place - 0.5 * thick * normal;
  DVec3 one = glm::normalize(glm::cross(normal, reference_axis(normal))), other = glm::cross(normal, one);
  auto direction = [&](int k) {
    double angle = kPi * k / kDirections;
    return std::cos(angle) * one + std::sin(angle) * other;
  };
  double forward[kDirections], backward[kDirections];
  int narrow = 0;
  auto width = [&](int k) { return forward[k] + backward[k]; };
  for (int k = 0; k < kDirections; ++k) {
    forward[k] = room(host, middle, direction(k), kLongest * thickest);
    backward[k] = room(host, middle, -direction(k), kLongest * thickest);
    if (width(k) < width(narrow)) narrow = k;
  }
  if (width(narrow) > thickest) return std::nullopt;
  middle += 0.5 * (forward[narrow] - backward[narrow]) * direction(narrow);
  DVec3 axis = glm::normalize(glm::cross(normal, direction(narrow)));
  return Pole{middle, axis.y < 0 ? -axis : axis, 0.5 * std::max(thick, width(narrow))};
}

std::vector<DVec3> wound_line(const TriangleSurface& host, const Pole& pole, const DVec3& from, double turns,
                              double lift, double pitch, double hand) {
  // From this far, in halves of the pole, places are moved to the surface nearest to them, so that some come
  // to each edge of a pole with edges.
  constexpr double kAround = 2.5;
  DVec3 off = from - pole.middle;
  off -= glm::dot(off, pole.axis) * pole.axis;
  double away = glm::length(off), round = pole.half + lift;
  if (away < 1.2 * round) return {};
  DVec3 one = off / away, other = hand * glm::cross(pole.axis, one);
  double touch = std::acos(round / away);  // where the way from there is a tangent
  int last = std::max(2, static_cast<int>(std::lround(kRoundNodes * turns)));
  std::vector<DVec3> line;
  for (int i = 0; i <= last; ++i) {
    double turned = turns * i / last, angle = touch + 2 * kPi * turned;
    DVec3 out = std::cos(angle) * one + std::sin(angle) * other;
    DVec3 at = pole.middle + pitch * turned * pole.axis + (kAround * pole.half + lift) * out;
    std::optional<Contact> near = host.closest(at);
    if (!near || near->inside) return {};
    line.push_back(near->point + lift * near->normal);
  }
  return line;
}

std::vector<DVec3> curled_line(const DVec3& tip, const DVec3& direction, const DVec3& aside, double radius,
                               double turns, double rise) {
  DVec3 beside = glm::cross(direction, aside);
  int last = static_cast<int>(std::lround(kRoundNodes * turns));
  std::vector<DVec3> line;
  DVec3 at = tip;
  for (int i = 1; i <= last; ++i) {
    double share = (i - 0.5) / last, angle = 2 * kPi * turns * share;
    double arc = 2 * kPi * turns / last * radius * (1 - 0.5 * share);
    at += arc * (std::cos(angle) * direction + std::sin(angle) * aside) + rise * turns / last * beside;
    line.push_back(at);
  }
  return line;
}

}  // namespace frond
