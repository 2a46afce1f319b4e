#include "creeping/tip.h"

#include <algorithm>
#include <cassert>

#include "core/noise.h"

namespace frond {

namespace {

constexpr double kTooNear = 0.55;      // of the spacing: nobody goes nearer to a neighbour than this
constexpr double kMuchTooNear = 0.35;  // nor than this where it is crowded already
constexpr double kOverhang = -0.5;     // the height of the normal below which a surface is one,
constexpr double kNoOverhang = -0.1;   // and above which it is none any more

/// The direction of the lure, and how much of the bias applies here.
DVec3 lured(const Crawl& crawl, const Tread& tread, double when, double& share) {
  DVec3 toward(crawl.toward.at(when));
  share = crawl.bias.at(when);
  if (crawl.lure == Lure::point) return toward - tread.place;
  if (crawl.lure == Lure::round) {
    DVec3 up(0, 1, 0), aside = glm::cross(up, tread.normal) * (crawl.pitch < 0 ? -1.0 : 1.0);
    return aside * std::cos(crawl.pitch) + up * std::abs(std::sin(crawl.pitch));
  }
  if (double length = glm::length(toward); crawl.lure == Lure::light && length > 0)
    share *= 1 - std::max(glm::dot(tread.normal, toward) / length, 0.0);
  return toward;
}

/// A heading that follows a guide: along it in its middle, back to it near its rim.
DVec3 guided(const Guides::View& guide, const DVec3& heading, const DVec3& normal) {
  constexpr double kAlong = 0.25, kBack = 0.6;   // share of a turn to it, and more of it at the rim
  constexpr double kMiddle = 0.3, kAtRim = 0.9;  // shares of its width
  double rim = smooth_step(kMiddle, kAtRim, guide.distance / guide.width);
  DVec3 toward = guide.along;
  if (guide.distance > 0) toward += guide.toward * (2 * rim / guide.distance);
  return leaning(heading, normal, toward, guide.pull * (kAlong + kBack * rim));
}

/// Within the box, and a strand's radius above the ground.
bool in_bounds(const Crawl& crawl, const GroundHeight& ground, const DVec3& p) {
  return (!ground || p.y >= ground(p.x, p.z) + crawl.radius) &&
         glm::all(glm::greaterThanEqual(p, DVec3(crawl.low))) &&
         glm::all(glm::lessThanEqual(p, DVec3(crawl.high)));
}

void stop(Tip& tip, End why) {
  tip.alive = false;
  tip.end = why;
}

void block(Tip& tip, const Crawl& crawl, End why) {
  if (++tip.blocked >= crawl.patience) stop(tip, why);
}

/// Turns a tip that leaves no strand to somewhere behind it.
void turn_back(Tip& tip, Seed draw) {
  double angle = draw.child("back").range(0.6 * kPi, 1.4 * kPi);
  tip.tread.heading = turned(tip.tread.heading, tip.tread.normal, angle);
}

void let_go(Tip& tip, const TriangleSurface& host, const GroundHeight& ground, const Crawl& crawl) {
  assert(!tip.hangs);
  tip.hangs = true;
  tip.chain = Chain{};
  tip.chain.root = tip.tread.place;
  tip.chain.heading = tip.tread.heading;
  tip.chain.link = crawl.speed;
  tip.chain.stiffness = crawl.stiffness;
  tip.chain.lift = 0.5 * crawl.radius;
  // At the rim of a hole half of all is behind.
  constexpr double kWithin = 0.75;
  tip.chain.outside = !crawl.backs && !host.closed() && backs_seen(host, tip.tread.place).share < kWithin;
  if (ground) tip.chain.ground = &ground;
}

/// Notes a node at the tip's tread, and the bud that is due there.
void lay(Tip& tip, const Crawl& crawl, double time) {
  Laid node{tip.tread, time, tip.along, tip.hangs, false};
  if (!tip.hangs && tip.depth < crawl.branch_depth && tip.along >= tip.next_bud) {
    node.bud = true;
    double vary = crawl.branch_jitter * tip.seed.child("bud", tip.buds++).range(-1, 1);
    tip.next_bud = tip.along + crawl.branch_every * (1 + vary);
  }
  tip.laid.push_back(node);
}

/// Whether an edge ends the surface ahead, rather than being one of a rough surface that goes on. What twines
/// goes round edges of its pole: only above it that ends.
bool falls_away(const TriangleSurface& host, const Tip& tip, const Crawl& crawl) {
  DVec3 ahead = crawl.lure == Lure::round ? DVec3(0, 1, 0) : tip.tread.heading;
  return !host.closest(tip.tread.place + ahead * (2 * crawl.speed), 0.5 * crawl.speed);
}

/// Walks a step over the surface, in strides.
void creep(Tip& tip, const TriangleSurface& host, const GroundHeight& ground, const Crawl& crawl, int step,
           Seed draw) {
  assert(!tip.hangs && crawl.speed > 0 && crawl.radius > 0);
  double lift = lift_of(crawl), rest = crawl.speed, unlaid = 0;
  constexpr int kMostStrides = 24;
  constexpr double kLeastRest = 0.05;    // of a step: no stride is made for less
  constexpr double kLeastStride = 0.02;  // of a step: a stride counts as that at least
  constexpr double kCalm = 3;            // steps since the last edge, before which no other one counts
  const double least = kLeastRest * crawl.speed;
  for (int strides = 0; rest > least && strides < kMostStrides; ++strides) {
    Stride s = stride(host, tip.tread, rest, lift);
    if (s.footing == Footing::stuck) {
      if (tip.laid.empty()) block(tip, crawl, End::stuck);
      break;
    }
    bool overhang = s.tread.normal.y < kOverhang && !tip.under;
    if (overhang || s.tread.normal.y > kNoOverhang) tip.under = overhang;
    if (overhang ||
        (s.footing == Footing::edge && tip.calm > kCalm * crawl.speed && falls_away(host, tip, crawl))) {
      tip.calm = 0;
      if (draw.child(8 + strides).unit() < crawl.let_go) return let_go(tip, host, ground, crawl);
    }
    if (s.footing == Footing::edge && !crawl.backs && host.behind(s.tread.triangle, s.tread.normal) &&
        !host.behind(tip.tread.triangle, tip.tread.normal)) {
      // A rim: hang over it or turn away.
      Seed rim = draw.child(64 + strides);
      if (rim.child(1).unit() < crawl.let_go) return let_go(tip, host, ground, crawl);
      double angle = rim.child(2).range(0.5 * kPi, kPi) * (rim.child(3).unit() < 0.5 ? -1 : 1);
      tip.tread.heading = turned(tip.tread.heading, tip.tread.normal, angle);
      if (tip.laid.empty()) block(tip, crawl, End::stuck);
      return;
    }
    bool free = in_bounds(crawl, ground, s.tread.place) && !barred(crawl, host, s.tread);
    if (!free && !crawl.trace) return turn_back(tip, draw);
    tip.calm += s.length;
    tip.along += s.length;
    tip.tread = s.tread;
    unlaid += s.length;
    rest -= std::max(s.length, kLeastStride * crawl.speed);
    if (!free) return stop(tip, End::box);
    if (unlaid > std::min(least, 0.5 * lift) || rest <= least) {
      lay(tip, crawl, step + 1 - std::max(rest, 0.0) / crawl.speed);
      unlaid = 0;
    }
  }
  if (!tip.laid.empty()) tip.blocked = 0;
  if (tip.along >= crawl.max_length) stop(tip, End::length);
}

/// Takes hold again where the end of the chain touches the host; ends where it has come down on the ground.
void grip(Tip& tip, const TriangleSurface& host, const Crawl& crawl) {
  assert(tip.hangs);
  constexpr double kTouch = 1.2;     // of the lift: so near it touches
  constexpr double kSearch = 4;      // of the lift: so near the host must be found then
  constexpr int kTouchSweeps = 100;  // until it is nearly at rest
  Chain& chain = tip.chain;
  auto touches = [&] {
    double moved = glm::distance(chain.clear.back(), chain.place.back());
    return chain.room.back() - moved < kTouch * chain.lift;
  };
  if (chain.place.size() < 3 || !touches()) return;
  settle(chain, host, kTouchSweeps);
  if (!touches()) return;
  std::optional<Contact> under = host.closest(chain.place.back(), kSearch * chain.lift);
  if (!under) return stop(tip, End::box);
  if (under->distance < 1e-3 * chain.lift) return;
  std::size_t n = chain.place.size();
  DVec3 last = chain.place[n - 1] - chain.place[n - 2];
  if (!crawl.backs && host.behind(under->triangle, (chain.place[n - 1] - under->point) / under->distance))
    return;
  Tread& t = tip.tread;
  t.contact = under->point;
  t.normal = (chain.place[n - 1] - under->point) / under->distance;
  t.place = t.contact + t.normal * lift_of(crawl);
  t.heading = tangent(last, t.normal);
  t.triangle = under->triangle;
  if (barred(crawl, host, t)) return stop(tip, End::box);
  tip.hangs = false;
  tip.gripped = true;
  tip.calm = 0;
}

/// Grows a hanging strand by a link.
void dangle(Tip& tip, const TriangleSurface& host, const Crawl& crawl, int step) {
  constexpr double kCurl = 0.8, kMostCurl = 0.4;  // of the wander; at most, of a link
  constexpr double kCurlRate = 0.16;              // units of the noise from link to link
  constexpr int kLinkSweeps = 4;
  Chain& chain = tip.chain;
  if (chain.length() + chain.link > crawl.hang_most) return stop(tip, End::hung);
  std::size_t n = chain.place.size();
  DVec3 last = n == 0 ? chain.heading : chain.place[n - 1] - (n == 1 ? chain.root : chain.place[n - 2]);
  // It grows in slow curves of its own, the more so the less weight pulls it straight.
  double shift = tip.seed.child("curl").range(-500, 500);
  DVec3 curl = DVec3(noise3(Vec3(shift, kCurlRate * static_cast<double>(n), 0))) *
               std::min(kCurl * crawl.wander, kMostCurl);
  if (!lengthen(chain, host, glm::normalize(glm::normalize(last) + curl), curl))
    return block(tip, crawl, End::stuck);
  settle(chain, host, kLinkSweeps);
  tip.along += chain.link;
  DVec3 along = glm::normalize(last);
  tip.tread.place = tip.tread.contact = chain.place.back();
  tip.tread.normal = tangent(tip.tread.normal, along);
  lay(tip, crawl, step + 1);
  grip(tip, host, crawl);
  if (tip.along >= crawl.max_length) stop(tip, End::length);
  if (!in_bounds(crawl, {}, tip.tread.place)) stop(tip, End::box);
}

/// A heading with `spacing` metres of room, at most the crowd's, near the wanted one; nothing where there is
/// none. `near` is overwritten.
std::optional<DVec3> heading_with_room(const SpatialHash& crowd, double spacing, const Tread& tread,
                                       const DVec3& heading, const SpatialHash::Own& own, double step,
                                       std::vector<DVec3>& near) {
  double probe = std::max(step, 0.5 * spacing);
  crowd.gather(tread.place, tread.normal, own, spacing + probe, near);
  if (near.empty()) return heading;
  SpatialHash::View straight = crowd.view(near, tread.place + heading * probe);
  if (straight.nearest >= spacing) return heading;
  DVec3 best = heading;
  double room = straight.nearest;
  auto consider = [&](const DVec3& h) {
    double there = crowd.nearest(near, tread.place + h * probe);
    if (there <= room) return;
    best = h;
    room = there;
  };
  // Away from the neighbours, the more the nearer they are.
  DVec3 away = straight.away - tread.normal * glm::dot(straight.away, tread.normal);
  double strength = glm::length(away);
  constexpr double kAway = 0.8;  // beside the heading's 1, where the nearest is at no distance
  if (strength > 1e-9)
    consider(glm::normalize(heading + away * (kAway * (1 - straight.nearest / spacing) / strength)));
  if (room >= kTooNear * spacing) return best;
  // Not back on itself: a strand that finds no way ahead stops.
  for (double angle : {30.0, -30.0, 60.0, -60.0}) {
    consider(turned(heading, tread.normal, radians(angle)));
    if (room >= kTooNear * spacing) return best;
  }
  // Who is crowded already may go where it is less so.
  if (room > kMuchTooNear * spacing && room > crowd.nearest(near, tread.place)) return best;
  return std::nullopt;
}

}  // namespace

Tip sprout(const Tread& tread, const Crawl& crawl, Seed seed) {
  Tip tip;
  tip.tread = tread;
  tip.seed = seed;
  tip.next_bud = crawl.branch_every * seed.child("first bud").range(1 - crawl.branch_jitter, 1);
  return tip;
}

void advance(Tip& tip, const CrawlWorld& world, const SpatialHash* crowd, const Crawl& crawl, int step) {
  tip.laid.clear();
  tip.gripped = false;
  Seed draw = tip.seed.child(static_cast<std::uint64_t>(step));
  if (tip.hangs) return dangle(tip, world.host, crawl, step);
  const Guides& guides = world.guides;
  if (tip.lead.curve < 0 && !guides.empty()) tip.lead = guides.find(tip.tread.place);
  const DVec3& normal = tip.tread.normal;
  DVec3 heading = turned(tip.tread.heading, normal, crawl.wander * draw.child(0).range(-1, 1));
  double share;
  DVec3 lure = lured(crawl, tip.tread, static_cast<double>(step) / crawl.max_age, share);
  if (crawl.mask && crawl.mask->scaling("bias")) share *= mask_at(crawl, world.host, tip.tread);
  heading = leaning(heading, normal, lure, share);
  if (tip.lead.curve >= 0) heading = guided(guides.follow(tip.tread.place, tip.lead), heading, normal);
  if (crowd) {
    double spacing = spacing_at(crawl, world.host, tip.tread);
    std::optional<DVec3> free = heading_with_room(*crowd, spacing, tip.tread, heading,
                                                  {tip.strand, tip.parent, tip.along}, crawl.speed, tip.near);
    if (!free) return crawl.trace ? block(tip, crawl, End::crowded) : turn_back(tip, draw);
    heading = tangent(*free, normal);
  }
  tip.tread.heading = heading;
  creep(tip, world.host, world.ground, crawl, step, draw);
  if (tip.lead.curve < 0 || tip.hangs) return;
  Guides::View guide = guides.follow(tip.tread.place, tip.lead);
  if (guide.ended || guide.distance > guide.width - crawl.speed) stop(tip, End::guide);
}

}  // namespace frond
