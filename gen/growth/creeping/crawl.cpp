#include "creeping/crawl.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "creeping/gather.h"
#include "creeping/tip.h"

namespace frond {

namespace {

/// Everything while it grows.
struct Growing {
  const TriangleSurface& host;
  const GroundHeight& ground;
  const Crawl& crawl;
  Guides guides;
  std::vector<Tip> tips;            // of all strands, living or not
  std::vector<std::int32_t> alive;  // which tips grow
  Nodes nodes;
  SpatialHash crowd;
  CrawlWorld world{host, ground, guides};
  std::vector<std::int32_t> last{};  // node of each strand
  std::vector<DVec3> near{};
};

void remember(Growing& g, Tip& tip, const Laid& laid) {
  assert(tip.strand >= 0 && tip.strand < static_cast<std::int32_t>(g.last.size()));
  g.last[tip.strand] = g.nodes.add(laid, g.last[tip.strand], tip.strand);
  if (laid.hanging) {
    tip.hung.push_back(g.last[tip.strand]);
  } else if (g.crawl.spacing > 0 && g.crawl.trace) {
    g.crowd.add(
        {Vec3(laid.tread.place), Vec3(laid.tread.normal), tip.strand, static_cast<float>(laid.along)});
  }
}

void begin(Growing& g, Tip tip, std::int32_t below) {
  assert(below < static_cast<std::int32_t>(g.nodes.laid.size()));
  assert(g.last.size() == g.tips.size());
  tip.strand = static_cast<std::int32_t>(g.tips.size());
  g.last.push_back(below);
  g.alive.push_back(tip.strand);
  g.tips.push_back(std::move(tip));
}

/// Starts a branch to one side or, where there is no room, to the other. False where there is none.
bool branch(Growing& g, std::int32_t from, const Tread& at, std::int32_t node) {
  assert(from >= 0 && from < static_cast<std::int32_t>(g.tips.size()) && node >= 0);
  Seed seed = g.tips[from].seed.child("branch", static_cast<std::uint64_t>(g.tips[from].branches++));
  constexpr double kRoomBeside = 0.8;  // of the spacing: where a branch looks for room, and how much it needs
  double side = seed.child("side").unit() < 0.5 ? -1 : 1, spacing = spacing_at(g.crawl, g.host, at);
  for (double sign : {side, -side}) {
    Tread t = at;
    t.heading = turned(t.heading, t.normal, sign * g.crawl.branch_angle);
    if (spacing > 0) {
      DVec3 ahead = t.place + t.heading * (kRoomBeside * spacing);
      g.crowd.gather(ahead, t.normal, {-2, from, 0}, spacing, g.near);
      if (g.crowd.nearest(g.near, ahead) < kRoomBeside * spacing) continue;
    }
    Tip tip = sprout(t, g.crawl, seed);
    tip.parent = from;
    tip.lead = g.tips[from].lead;
    tip.depth = g.tips[from].depth + 1;
    begin(g, std::move(tip), node);
    return true;
  }
  return false;
}

/// A strand that has come to its end wakes buds that sleep along it, wherever there is room beside it: the
/// reiteration of Benes and Millan (2002). What is bare between strands is filled from its rim.
void wake(Growing& g, std::int32_t t) {
  const Tip& tip = g.tips[t];
  if (tip.depth >= g.crawl.branch_depth || g.crawl.waking <= 0) return;
  Seed seed = tip.seed.child("waking");
  double last = 0, apart = std::max(g.crawl.spacing, 0.5 * g.crawl.branch_every);
  std::vector<std::int32_t> own = tip.own;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const Laid& laid = g.nodes.laid[own[k]];
    if (laid.along < last + apart || seed.child(k).unit() >= g.crawl.waking) continue;
    last = laid.along;
    branch(g, t, laid.tread, own[k]);
  }
}

/// Gives a chain's nodes the places where it has come to hang.
void set_hung(Growing& g, Tip& tip) {
  assert(tip.hung.size() <= tip.chain.place.size());
  for (std::size_t i = 0; i < tip.hung.size(); ++i)
    g.nodes.laid[tip.hung[i]].tread.place = g.nodes.laid[tip.hung[i]].tread.contact = tip.chain.place[i];
}

/// Takes what a tip has done in this step into the whole. False where there is no room for more nodes.
bool commit_step(Growing& g, std::int32_t t) {
  for (std::size_t k = 0; k < g.tips[t].laid.size(); ++k) {
    if (g.nodes.laid.size() >= g.crawl.most_nodes) return false;
    Laid laid = g.tips[t].laid[k];
    remember(g, g.tips[t], laid);
    if (laid.bud) branch(g, t, laid.tread, g.last[t]);
  }
  Tip& tip = g.tips[t];
  if (tip.gripped) {
    set_hung(g, tip);
    tip.hung.clear();
  }
  if (!tip.alive && tip.end != End::length && g.crawl.spacing > 0 && g.crawl.trace) wake(g, t);
  return true;
}

void step_all(Growing& g, int step) {
  const SpatialHash* crowd = g.crawl.spacing > 0 ? &g.crowd : nullptr;
  if (crowd && !g.crawl.trace) {
    g.crowd = SpatialHash(g.crawl.spacing);
    for (std::int32_t t : g.alive) {
      const Tip& tip = g.tips[t];
      g.crowd.add({Vec3(tip.tread.place), Vec3(tip.tread.normal), t, static_cast<float>(tip.along)});
    }
  }
  auto one = [&](std::size_t i) { advance(g.tips[g.alive[i]], g.world, crowd, g.crawl, step); };
  // Tips only read what the last step left: the order in which they are asked does not matter.
  constexpr std::size_t kBlock = 32;
  std::size_t blocks = (g.alive.size() + kBlock - 1) / kBlock;
  if (blocks < 2) {
    for (std::size_t i = 0; i < g.alive.size(); ++i) one(i);
    return;
  }
  parallel_for(blocks, [&](std::size_t b) {
    for (std::size_t i = b * kBlock; i < std::min((b + 1) * kBlock, g.alive.size()); ++i) one(i);
  });
}

/// Lets what hangs come to rest.
void rest_all(Growing& g) {
  std::vector<std::int32_t> hanging;
  for (const Tip& tip : g.tips)
    if (tip.hangs && !tip.hung.empty()) hanging.push_back(tip.strand);
  parallel_for(hanging.size(), [&](std::size_t i) {
    Chain& chain = g.tips[hanging[i]].chain;
    constexpr int kRounds = 25, kSweeps = 20;
    constexpr double kAtRest = 5e-4;  // of a link: the farthest that a node moves in the last sweep
    for (int round = 0; round <= kRounds; ++round)
      if (settle(chain, g.host, kSweeps, static_cast<double>(round) / kRounds) < kAtRest) break;
  });
  for (std::int32_t t : hanging) set_hung(g, g.tips[t]);
}

/// Where a strand begins, or nothing where that is buried in the host or the ground.
std::optional<Tread> begin_at(const Growing& g, const Start& start) {
  double lift = lift_of(g.crawl);
  std::optional<Tread> tread = tread_at(g.host, start.place, start.heading, lift);
  auto sunk = [&] {
    return g.ground ? g.ground(tread->place.x, tread->place.z) + g.crawl.radius - tread->place.y : 0;
  };
  for (int i = 0; i < 4 && tread && sunk() > 0; ++i)
    tread = tread_at(g.host, tread->place + DVec3(0, sunk() + lift, 0), start.heading, lift);
  if (tread && (sunk() > 0 || g.host.inside(tread->place) || barred(g.crawl, g.host, *tread)))
    return std::nullopt;
  return tread;
}

}  // namespace

Strands grow_strands(const TriangleSurface& host, const std::vector<Start>& starts, const Crawl& crawl,
                     Seed seed, const GroundHeight& ground) {
  Crawl own = crawl;
  if (!own.trace) own.branch_depth = 0, own.let_go = 0;
  Growing g{host, ground, own, Guides(host, own.guides),
            {},   {},     {},  SpatialHash(own.spacing > 0 ? own.spacing : 1)};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    std::optional<Tread> tread = begin_at(g, starts[i]);
    if (!tread) continue;
    Tip tip = sprout(*tread, own, seed.child("start", i));
    if (starts[i].curve >= 0) tip.lead = g.guides.find(tread->place, starts[i].curve);
    begin(g, std::move(tip), -1);
    remember(g, g.tips.back(), {*tread, 0, 0, false, false});
  }
  bool room = true;
  for (int step = 0; step < own.max_age && room && !g.alive.empty(); ++step) {
    step_all(g, step);
    std::size_t count = g.alive.size();
    for (std::size_t i = 0; i < count && room; ++i) room = commit_step(g, g.alive[i]);
    std::erase_if(g.alive, [&](std::int32_t t) { return !g.tips[t].alive; });
  }
  if (!room)
    for (std::int32_t t : g.alive) g.tips[t].end = End::nodes;
  rest_all(g);
  std::vector<Strand> strands;
  for (const Tip& tip : g.tips) strands.push_back({0, 0, tip.parent, tip.end});
  std::vector<int> depths;
  for (const Tip& tip : g.tips) depths.push_back(tip.depth);
  return gather(host, ground, g.nodes, strands, depths, own);
}

}  // namespace frond
