#include "creeping/hang.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr double kSlope = 0.5;     // the ground is no nearer than this share of the height above it
constexpr double kEnough = 0.98;   // of the lift: nearer to anything than this is too near
constexpr double kPushed = 0.1;    // of a link, and the lift: a push out of where it may not be
constexpr double kKnown = 4;       // links: the room about a place is known as far as this
constexpr double kNearHole = 0.1;  // share of backs seen, from which a hole is near
constexpr double kWatched = 0.25;  // links: no more room is taken as known near a hole
constexpr int kPlaceTries = 8;

/// What hinders the end of link `i`, which begins at `at`, from being at `to`: the offset to push it by, or
/// nothing. What is known of the room about it saves most questions; `to` is known where nothing hinders.
std::optional<DVec3> hindrance(Chain& chain, const TriangleSurface& host, std::size_t i, const DVec3& at,
                               const DVec3& to) {
  assert(i < chain.room.size() && chain.link > 0);
  DVec3 offset = to - chain.clear[i];
  double gone = glm::length(offset), reach = kKnown * chain.link;
  double room = chain.room[i] - gone;
  if (room < chain.lift) {
    double height = chain.ground ? to.y - (*chain.ground)(to.x, to.z) : reach / kSlope;
    if (height < kEnough * chain.lift) return DVec3(0, chain.lift - height, 0);
    if (std::optional<Crossing> wall = host.crossing(chain.clear[i], to)) {
      DVec3 face = glm::dot(wall->normal, offset) > 0 ? -wall->normal : wall->normal;
      return face * (chain.lift - (1 - wall->share) * glm::dot(offset, face));
    }
    std::optional<Contact> near = host.closest(to, reach);
    room = near ? near->distance : reach;
    if (near && room < kEnough * chain.lift) {
      if (room < 1e-6 * chain.lift) return -offset;
      return (to - near->point) * (chain.lift / room - 1);
    }
    if (chain.outside) {
      // No face is in the way of what slips in through a hole. Near one it is watched at each turn.
      BacksSeen backs = backs_seen(host, to);
      if (backs.share > kBehind) return backs.out * (kPushed * chain.link + chain.lift);
      if (backs.share > kNearHole) room = std::min(room, std::max(kWatched * chain.link, chain.lift));
    }
    room = std::min(room, kSlope * height);
  }
  // Where balls of free room round both ends do not meet, the link between may cut an edge.
  double below = i == 0 ? 0 : chain.room[i - 1] - glm::distance(chain.clear[i - 1], at);
  if (room + below < chain.link)
    if (std::optional<Crossing> edge = host.crossing(at, to)) {
      DVec3 face = glm::dot(edge->normal, to - at) > 0 ? -edge->normal : edge->normal;
      return face * (kPushed * chain.link + chain.lift);
    }
  chain.clear[i] = to;
  chain.room[i] = room;
  return std::nullopt;
}

/// Puts the end of link `i` as near to a direction as the host lets it. False where there is no way.
bool place_link(Chain& chain, const TriangleSurface& host, std::size_t i, const DVec3& at, DVec3 direction) {
  for (int again = 0; again < kPlaceTries; ++again) {
    DVec3 to = at + direction * chain.link;
    std::optional<DVec3> push = hindrance(chain, host, i, at, to);
    if (!push) {
      chain.place[i] = to;
      return true;
    }
    // Half a push farther each time.
    DVec3 aside = direction * chain.link + *push * (1 + 0.5 * again);
    double length = glm::length(aside);
    if (!(length > 0)) return false;
    direction = aside / length;
  }
  return false;
}

}  // namespace

BacksSeen backs_seen(const TriangleSurface& host, const DVec3& place) {
  if (host.closed()) return {};
  constexpr int kDirections = 40;
  static const std::array<DVec3, kDirections> directions = [] {
    std::array<DVec3, kDirections> all;
    for (int i = 0; i < kDirections; ++i) {  // evenly, along a spiral
      double y = 1 - (2 * i + 1.0) / kDirections, turn = kPi * (3 - std::sqrt(5.0)) * i,
             r = std::sqrt(1 - y * y);
      all[i] = {r * std::cos(turn), y, r * std::sin(turn)};
    }
    return all;
  }();
  int backs = 0;
  DVec3 out(0);
  for (const DVec3& direction : directions) {
    std::optional<Crossing> seen = host.crossing(place, place + direction * host.size());
    bool back = seen && host.behind(seen->triangle, -seen->normal) && glm::dot(seen->normal, direction) > 0;
    backs += back;
    out += back ? -direction : direction;
  }
  double length = glm::length(out);
  return {static_cast<double>(backs) / kDirections, length > 0 ? out / length : DVec3(0, 1, 0)};
}

bool lengthen(Chain& chain, const TriangleSurface& host, const DVec3& direction, const DVec3& curl) {
  assert(std::abs(glm::length(direction) - 1) < 1e-6);
  DVec3 from = chain.place.empty() ? chain.root : chain.place.back();
  chain.place.push_back(from);
  chain.curl.push_back(curl);
  chain.load.push_back(DVec3(0));
  chain.clear.push_back(from);
  chain.room.push_back(0);
  if (place_link(chain, host, chain.place.size() - 1, from, direction)) return true;
  chain.place.pop_back();
  chain.curl.pop_back();
  chain.load.pop_back();
  chain.clear.pop_back();
  chain.room.pop_back();
  return false;
}

double settle(Chain& chain, const TriangleSurface& host, int sweeps, double calm) {
  assert(calm >= 0 && calm <= 1 && chain.link > 0);
  assert(chain.curl.size() == chain.place.size() && chain.load.size() == chain.place.size());
  assert(chain.clear.size() == chain.place.size() && chain.room.size() == chain.place.size());
  constexpr double kEager = 1.8, kCalmer = 0.8;  // over-relaxation, and less of it by calm
  constexpr double kGain = 0.5;                  // of a push, and at no calm, becomes a load
  constexpr double kForgotten = 0.2;             // of a load is lost for each of that
  const double eager_by = kEager - kCalmer * calm;
  std::size_t n = chain.place.size();
  std::vector<DVec3> link(n);
  double stiff = chain.stiffness * chain.stiffness * chain.stiffness / chain.link;
  double moved = 0;
  std::vector<DVec3> place, clear;  // before a sweep
  std::vector<double> room;
  std::vector<DVec3> beyond(n);  // what pulls at each link: weight, and what bears it
  auto bend = [&](std::size_t i) {
    DVec3 before = (i == 0 ? chain.heading : link[i - 1]) + chain.curl[i];
    DVec3 pull = stiff * before + chain.link * beyond[i];
    if (i + 1 < n) pull += stiff * (link[i + 1] - chain.curl[i + 1]);
    double force = glm::length(pull);
    DVec3 eager = eager_by * pull - (eager_by - 1) * force * link[i];
    double length = glm::length(eager);
    if (length > 1e-12 * force && force > 0) link[i] = eager / length;
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < n; ++i)
      link[i] = (chain.place[i] - (i == 0 ? chain.root : chain.place[i - 1])) / chain.link;
    DVec3 sum(0, 0.5 * chain.link, 0);
    for (std::size_t i = n; i-- > 0;) beyond[i] = sum += chain.load[i] - DVec3(0, chain.link, 0);
    for (std::size_t i = 0; i < n; ++i) bend(i);
    for (std::size_t i = n; i-- > 0;) bend(i);
    place = chain.place;
    clear = chain.clear;
    room = chain.room;
    moved = 0;
    DVec3 at = chain.root;
    for (std::size_t i = 0; i < n; ++i) {
      if (!place_link(chain, host, i, at, link[i])) {
        // Wedged: it stays as it was.
        chain.place = place;
        chain.clear = clear;
        chain.room = room;
        return 0;
      }
      // The push that it took becomes a load that the links above feel, too.
      DVec3 pushed = chain.place[i] - (at + link[i] * chain.link);
      double gain = kGain * (1 - calm);
      chain.load[i] = (1 - kForgotten * gain) * chain.load[i] + gain * static_cast<double>(n) * pushed;
      at = chain.place[i];
      moved = std::max(moved, glm::distance(at, place[i]) / chain.link);
    }
  }
  return moved;
}

}  // namespace frond
