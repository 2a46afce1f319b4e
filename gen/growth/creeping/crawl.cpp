#include "creeping/crawl.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "creeping/tip.h"

namespace frond {

namespace {

/// Nodes in the order in which they were laid.
struct Nodes {
  std::vector<Laid> laid;
  std::vector<std::int32_t> below;  ///< the node before it, or -1
  std::vector<std::int32_t> strand;

  std::int32_t add(const Laid& node, std::int32_t parent, std::int32_t of) {
    laid.push_back(node);
    below.push_back(parent);
    strand.push_back(of);
    return static_cast<std::int32_t>(laid.size()) - 1;
  }
};

constexpr std::int32_t kLeast = 3;  // nodes of a strand that is crowded out

/// The strands that have a segment, renumbered, and where their nodes begin. Returns the new number of each.
std::vector<std::int32_t> keep_strands(const Nodes& nodes, const std::vector<Strand>& strands, Strands& out) {
  std::vector<std::int32_t> count(strands.size(), 0), number(strands.size(), -1);
  assert(nodes.strand.size() == nodes.laid.size() && nodes.below.size() == nodes.laid.size());
  for (std::int32_t s : nodes.strand) ++count[s];
  std::vector<std::uint8_t> bears(strands.size(), 0);
  for (const Strand& s : strands)
    if (s.parent >= 0) bears[s.parent] = 1;
  std::int32_t first = 0;
  for (std::size_t s = 0; s < strands.size(); ++s) {
    std::int32_t parent = strands[s].parent;
    assert(parent < static_cast<std::int32_t>(s) && "a strand begins after the one that it leaves");
    // Stubs that found no room at once, and branches of what is not there.
    bool stub = count[s] < kLeast && !bears[s] && strands[s].end == End::crowded;
    if (count[s] < (parent < 0 ? 2 : 1) || stub || (parent >= 0 && number[parent] < 0)) continue;
    number[s] = static_cast<std::int32_t>(out.strands.size());
    out.strands.push_back({first, count[s], parent < 0 ? -1 : number[parent], strands[s].end});
    first += count[s];
  }
  return number;
}

/// The order of the nodes strand by strand.
std::vector<std::int32_t> order_by_strand(const Nodes& nodes, const std::vector<std::int32_t>& number,
                                          const Strands& out) {
  std::size_t n = out.strands.empty() ? 0 : out.strands.back().first + out.strands.back().count;
  std::vector<std::int32_t> order(n), next;
  for (const Strand& s : out.strands) next.push_back(s.first);
  for (std::size_t i = 0; i < nodes.laid.size(); ++i)
    if (std::int32_t s = number[nodes.strand[i]]; s >= 0) order[next[s]++] = static_cast<std::int32_t>(i);
  return order;
}

/// Radii by age, times what the tips that a stem carries ask for.
std::vector<float> radii(const Strands& out, const std::vector<std::int32_t>& parent, const Crawl& crawl) {
  assert(out.age.size() == parent.size() && crawl.radius > 0);
  constexpr double kYoungest = 0.1;  // of the radius: that of the youngest node, as lift_of() has it
  std::size_t n = parent.size();
  std::vector<float> radius(n);
  std::vector<std::int32_t> carried(n, 0);
  for (std::size_t i = n; i-- > 0;) {
    carried[i] = std::max(carried[i], 1);
    if (parent[i] >= 0) carried[parent[i]] += carried[i];
    double young = std::clamp(out.age[i] * crawl.ripening, kYoungest, 1.0);
    double stem = crawl.pipe > 0 ? std::min(std::pow(carried[i], 1 / crawl.pipe), crawl.thickest) : 1.0;
    radius[i] = static_cast<float>(crawl.radius * young * stem);
  }
  return radius;
}

/// The place of a node above the surface; in a cleft that is narrower than the stem, half-way across.
DVec3 lifted(const TriangleSurface& host, const Tread& t, double radius) {
  DVec3 place = t.contact + t.normal * radius;
  DVec3 offset = place - t.place;
  if (glm::dot(offset, t.normal) <= 0) return place;
  if (std::optional<Crossing> wall = host.crossing(t.place, place))
    place = t.place + offset * (0.5 * wall->share);
  return place;
}

/// The places of all nodes. What hangs moves along as the node that holds it is lifted, if there is room.
std::vector<DVec3> places(const TriangleSurface& host, const GroundHeight& ground, const Nodes& nodes,
                          const std::vector<std::int32_t>& order, const std::vector<std::int32_t>& parent,
                          const std::vector<float>& radius) {
  std::size_t n = order.size();
  std::vector<DVec3> place(n);
  auto laid = [&](std::size_t i) -> const Laid& { return nodes.laid[order[i]]; };
  auto height = [&](const DVec3& p) { return ground ? p.y - ground(p.x, p.z) : 1; };
  parallel_for((n + 255) / 256, [&](std::size_t block) {
    for (std::size_t i = block * 256; i < std::min(n, (block + 1) * 256); ++i)
      place[i] = laid(i).hanging ? laid(i).tread.place : lifted(host, laid(i).tread, radius[i]);
  });
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i + 1;
    if (laid(i).hanging && parent[i] >= 0) {
      while (end < n && laid(end).hanging && parent[end] == static_cast<std::int32_t>(end) - 1) ++end;
      DVec3 root = place[parent[i]], shift = root - laid(parent[i]).tread.place;
      bool free = true;
      for (std::size_t k = i; k < end && free; ++k) {
        free = height(place[k] + shift) > 0 && !host.crossing(root, place[k] + shift) &&
               !host.crossing(place[k], place[k] + shift);
        root = place[k] + shift;
      }
      // The next one holds again.
      if (free && end < n && parent[end] == static_cast<std::int32_t>(end) - 1)
        free = !host.crossing(root, place[end]);
      for (std::size_t k = i; k < end && free; ++k) place[k] += shift;
    }
    i = end;
  }
  return place;
}

/// Orders the nodes strand by strand, sets their radii (I5 and the pipe model of Shinozaki et al. 1964) and
/// lifts them off the surface by these. Strands without a segment are dropped.
Strands gather(const TriangleSurface& host, const GroundHeight& ground, const Nodes& nodes,
               const std::vector<Strand>& strands, const std::vector<int>& depths, const Crawl& crawl) {
  Strands out;
  std::vector<std::int32_t> number = keep_strands(nodes, strands, out);
  std::vector<std::int32_t> order = order_by_strand(nodes, number, out);
  std::size_t n = order.size();
  std::vector<std::int32_t> index(nodes.laid.size(), -1), parent(n);
  for (std::size_t i = 0; i < n; ++i) index[order[i]] = static_cast<std::int32_t>(i);
  double end = 0;
  for (const Laid& laid : nodes.laid) end = std::max(end, laid.time);
  out.age.resize(n);
  out.normal.resize(n);
  out.contact.resize(n);
  out.room.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t below = nodes.below[order[i]];
    parent[i] = below < 0 ? -1 : index[below];
    assert(below < 0 || (parent[i] >= 0 && parent[i] < static_cast<std::int32_t>(i)));
    out.age[i] = static_cast<float>(end - nodes.laid[order[i]].time);
  }
  std::vector<float> radius = radii(out, parent, crawl);
  std::vector<DVec3> place = places(host, ground, nodes, order, parent, radius);
  parallel_for((n + 255) / 256, [&](std::size_t block) {
    for (std::size_t i = block * 256; i < std::min(n, (block + 1) * 256); ++i) {
      const Laid& laid = nodes.laid[order[i]];
      out.normal[i] = Vec3(laid.tread.normal);
      out.contact[i] = Vec3(laid.hanging ? place[i] : laid.tread.contact);
      if (!laid.hanging) continue;
      double far = 2 * crawl.hang_most;
      std::optional<Contact> near = host.closest(place[i], far);
      double room = near ? near->distance : far;
      if (ground) room = std::min(room, 0.5 * (place[i].y - ground(place[i].x, place[i].z)));
      out.room[i] = std::max(static_cast<float>(room) - radius[i], 0.0f);
    }
  });
  out.skeleton.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Laid& laid = nodes.laid[order[i]];
    std::int32_t s = nodes.strand[order[i]];
    out.skeleton.add(Vec3(place[i]), radius[i], parent[i], static_cast<std::uint16_t>(depths[s]));
    out.skeleton.birth.back() = end > 0 ? static_cast<float>(laid.time / end) : 0;
    out.hanging.push_back(laid.hanging);
    out.of.push_back(number[s]);
    if (crawl.mask && crawl.mask->scaling("leaves"))
      out.mask.push_back(laid.hanging ? 1.0f : static_cast<float>(mask_at(crawl, host, laid.tread)));
  }
  set_tip_distances(out.skeleton);
  return out;
}

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

bool CrawlMask::scaling(std::string_view what) const {
  return std::ranges::find(scales, what) != scales.end();
}

double CrawlMask::at(const TriangleSurface& host, std::uint32_t triangle, const DVec3& point) const {
  if (picture.along) return picture.at(point, host.low(), host.high());
  Vec3 paint = host.paint(triangle, point);
  if (picture.file.empty())
    return std::isnan(paint.z) ? 1.0 : std::clamp(static_cast<double>(paint.z), 0.0, 1.0);
  if (std::isnan(paint.x) || std::isnan(paint.y)) return 1;
  // Textures repeat beyond 0..1.
  auto within = [](double x) { return x < 0 || x > 1 ? x - std::floor(x) : x; };
  return picture.at_share(within(paint.x), 1 - within(paint.y));
}

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
