#include "growth/hang.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

/// A place near one that was free, moved out of the host where it came too near. What is known of the room
/// there saves most questions.
DVec3 kept_out(Chain& chain, const Host& host, std::size_t i, const DVec3& to) {
  DVec3& clear = chain.clear[i];
  double& room = chain.room[i];
  DVec3 way = to - clear;
  if (glm::dot(way, way) < (room - chain.lift) * (room - chain.lift) && room > chain.lift) return to;
  DVec3 place = to;
  if (std::optional<Crossing> wall = host.crossing(clear, to)) {
    DVec3 face = glm::dot(wall->normal, way) > 0 ? -wall->normal : wall->normal;
    place = clear + way * wall->share + face * chain.lift;
    // In a corner the lift may lead through the next wall.
    if (std::optional<Crossing> next = host.crossing(clear + way * (0.999 * wall->share), place))
      return clear;
  }
  std::optional<Contact> near = host.closest(place, 64 * chain.lift + 4 * chain.link);
  double distance = near ? near->distance : 64 * chain.lift + 4 * chain.link;
  if (near && distance < chain.lift && distance > 1e-6 * chain.lift) {
    place = near->point + (place - near->point) * (chain.lift / distance);
    distance = chain.lift;
  }
  clear = place;
  room = distance;
  return place;
}

}  // namespace

void lengthen(Chain& chain, const Host& host, const DVec3& direction) {
  DVec3 from = chain.place.empty() ? chain.root : chain.place.back();
  chain.place.push_back(from + direction * chain.link);
  chain.clear.push_back(from);
  chain.room.push_back(0);
  std::size_t i = chain.place.size() - 1;
  DVec3 free = kept_out(chain, host, i, chain.place[i]) - from;
  double length = glm::length(free);
  if (length > 0) chain.place[i] = from + free * (chain.link / length);
}

double settle(Chain& chain, const Host& host, int sweeps) {
  constexpr double kEager = 1.5;  // over-relaxation
  std::size_t n = chain.place.size();
  std::vector<DVec3> link(n);
  for (std::size_t i = 0; i < n; ++i)
    link[i] = (chain.place[i] - (i == 0 ? chain.root : chain.place[i - 1])) / chain.link;
  double stiff = chain.stiffness * chain.stiffness * chain.stiffness / chain.link;
  double weight = chain.link * chain.link, moved = 0;
  auto bend = [&](std::size_t i) {
    double beyond = static_cast<double>(n - i) - 0.5;
    DVec3 pull = stiff * (i == 0 ? chain.heading : link[i - 1]) - DVec3(0, weight * beyond, 0);
    if (i + 1 < n) pull += stiff * link[i + 1];
    double force = glm::length(pull);
    DVec3 eager = kEager * pull - (kEager - 1) * force * link[i];
    double length = glm::length(eager);
    if (length > 1e-12 * force && force > 0) link[i] = eager / length;
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < n; ++i) bend(i);
    for (std::size_t i = n; i-- > 0;) bend(i);
    moved = 0;
    DVec3 at = chain.root;
    for (std::size_t i = 0; i < n; ++i) {
      DVec3 to = at + link[i] * chain.link;
      for (int again = 0; again < 3; ++again) {
        DVec3 free = kept_out(chain, host, i, to);
        if (free == to) break;
        DVec3 way = free - at;
        double length = glm::length(way);
        if (length > 0) to = at + way * (chain.link / length);
      }
      moved = std::max(moved, glm::distance(to, chain.place[i]) / chain.link);
      link[i] = (to - at) / chain.link;
      at = chain.place[i] = to;
    }
  }
  return moved;
}

}  // namespace frond
