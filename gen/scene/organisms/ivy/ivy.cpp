#include "organisms/ivy/ivy.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "organisms/ivy/ivy_rest.h"

namespace frond {

namespace {

/// Along the foot of a host, which is where a buried one comes out of the ground.
std::vector<Start> starts_at_own_foot(const IvyParams& params, const Support& under, int count, Seed seed) {
  const TriangleSurface& host = under.host;
  DVec3 middle = 0.5 * (host.low() + host.high());
  double buried = under.ground ? std::max(under.ground(middle.x, middle.z) - host.low().y, 0.0) : 0;
  return starts_at_foot(host, count, buried + params.above, params.facing, seed.child("foot"));
}

/// Whether strands may not begin there: the host bars them, or the mask of the ivy does.
bool is_barred(const Start& start, const IvyParams& params, const TriangleSurface& host) {
  std::optional<Contact> near = host.closest(start.place);
  if (!near || host.paint(near->triangle, near->point).z < 0) return true;
  const std::optional<CrawlMask>& mask = params.crawl.mask;
  return mask && mask->stops > 0 && mask->at(host, near->triangle, near->point) < mask->stops;
}

/// Where strands may not begin none does: others begin all over what it leaves instead, far from each other
/// (Mitchell 1991, by the best of some candidates).
void move_into_mask(std::vector<Start>& starts, const IvyParams& params, const TriangleSurface& host,
                    Seed seed) {
  auto barred = [&](const Start& start) { return is_barred(start, params, host); };
  auto averted = [&](const Start& start) {
    DVec3 facing(params.facing);
    if (glm::length(facing) <= 0) return false;
    std::optional<Contact> near = host.closest(start.place);
    return !near || glm::dot(host.face_normal(near->triangle), glm::normalize(facing)) < 0.5;
  };
  std::size_t wanted = starts.size();
  std::erase_if(starts, barred);
  if (starts.size() == wanted) return;
  constexpr int kTries = 64;  // for each, so that they are found where little is left
  std::vector<Start> spread = starts_around(host, kTries * static_cast<int>(wanted),
                                            Vec3((host.low() + host.high()) / 2.0), host.size(), seed);
  std::erase_if(spread, [&](const Start& start) { return barred(start) || averted(start); });
  std::size_t group = std::clamp<std::size_t>(spread.size() / (wanted - starts.size()), 1, 12), next = 0;
  for (; starts.size() < wanted && next + group <= spread.size(); next += group) {
    auto room = [&](const Start& start) {
      double least = 1e9;
      for (const Start& other : starts) least = std::min(least, glm::distance(start.place, other.place));
      return least;
    };
    auto first = spread.begin() + static_cast<std::ptrdiff_t>(next);
    starts.push_back(*std::max_element(first, first + static_cast<std::ptrdiff_t>(group),
                                       [&](const Start& a, const Start& b) { return room(a) < room(b); }));
  }
}

/// Where the plants stand on the host.
std::vector<Start> starts_of(const IvyParams& params, const Support& under, const IvyRoots& roots, int count,
                             Seed seed) {
  const TriangleSurface& host = under.host;
  std::vector<Start> starts;
  for (const Vec3& root : roots) starts.push_back({.place = DVec3(root)});
  int more = count - static_cast<int>(roots.size());
  if (more <= 0) return starts;
  std::vector<Start> others;
  if (!params.crawl.guides.empty())
    others = starts_on_guides(params.crawl.guides, more);
  else if (params.crawl.trace)
    others = starts_at_own_foot(params, under, more, seed);
  // A host without a foot, such as a floating one, is rooted all round.
  if (others.empty() && roots.empty())
    others =
        starts_around(host, more, Vec3((host.low() + host.high()) / 2.0), host.size(), seed.child("around"));
  move_into_mask(others, params, host, seed.child("mask"));
  starts.insert(starts.end(), others.begin(), others.end());
  return starts;
}

/// Which colour of the bark each node has: the thicker, the older; the last is that of shoots.
std::vector<std::int32_t> bark_ages(const Skeleton& s, std::size_t colors, double radius) {
  constexpr double kShoots = 0.6, kOlder = 1.8;  // in radii: the thickest shoots; from there to the oldest
  std::vector<std::int32_t> age(s.size(), 0);
  auto last = static_cast<std::int32_t>(colors) - 1;
  for (std::size_t i = 0; i < s.size() && last > 0; ++i) {
    double share = std::clamp((s.radius[i] / radius - kShoots) / kOlder, 0.0, 0.999);
    age[i] = last - static_cast<std::int32_t>(share * (last + 1));
  }
  return age;
}

/// Where tendrils are: at each so many leaves of a strand one, opposite to its leaf.
std::vector<TendrilSite> tendril_sites(const Ivy& ivy, int every) {
  const Organs& leaves = ivy.model.organs;
  std::vector<std::size_t> order(leaves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return leaves.node[i]; });
  std::vector<TendrilSite> sites;
  std::int32_t strand = -1;
  int passed = 0;
  for (std::size_t i : order) {
    std::int32_t node = leaves.node[i];
    if (ivy.strands.of[node] != strand) strand = ivy.strands.of[node], passed = 0;
    if (passed++ % every == 0) sites.push_back({node, leaves.turn[i] * Vec3(0, -1, 0)});
  }
  return sites;
}

/// Adds them to strands and model. They have the colour after those of the bark.
void grow_tendrils(Ivy& ivy, const IvyParams& params, const Support& under, Seed seed) {
  constexpr double kSlower = 3;  // than a strand a tendril grows
  const Crawl& crawl = params.crawl;
  double time = kSlower * params.tendrils->reach / (crawl.speed * crawl.max_age);
  add_tendrils(ivy.strands, under.host, tendril_sites(ivy, params.tendrils->every), *params.tendrils, time,
               seed, under.ground);
  ivy.model.skeleton = ivy.strands.skeleton;
  ivy.model.color.resize(ivy.model.skeleton.size(), static_cast<std::int32_t>(params.bark.colors.size()));
}

/// Why nothing of it grows; a pointer below the organism and the reason.
Error rootless(const Crawl& crawl, const TriangleSurface& host) {
  DVec3 low = host.low(), high = host.high();
  auto corner = [](const DVec3& at) { return fmt::format("[{:.3g}, {:.3g}, {:.3g}]", at.x, at.y, at.z); };
  if (glm::any(glm::greaterThan(DVec3(crawl.low), high)) || glm::any(glm::lessThan(DVec3(crawl.high), low)))
    return error_at("/crawl",
                    "its box, from low to high, misses what the ivy grows on; expected one that holds some "
                    "of what lies from {} to {}",
                    corner(low), corner(high));
  return {"",
          "finds no place to root; expected place.at near what it grows on, another above and facing, or a "
          "larger box in crawl"};
}

}  // namespace

Result<Ivy> grow_ivy(const IvyParams& params, const TriangleSurface& host, const IvyRoots& roots, int count,
                     const GroundHeight& ground, Seed seed) {
  Support under{host, ground};
  std::vector<Start> starts = starts_of(params, under, roots, count, seed);
  Ivy ivy;
  ivy.strands = grow_strands(host, starts, params.crawl, seed.child("crawl"), ground);
  bool masked = params.crawl.mask && params.crawl.mask->stops > 0;
  if (ivy.strands.size() < 2 && masked && starts.size() == roots.size()) return Ivy{};
  if (ivy.strands.size() < 2) return rootless(params.crawl, host);
  if (!params.crawl.trace) {
    ivy.model.prototypes = walker_prototypes(params.walkers);
    ivy.model.organs = walkers_at(params.walkers, ivy.strands, 1, seed.child("walkers"));
    return ivy;
  }
  ivy.model.skeleton = ivy.strands.skeleton;
  ivy.model.color = bark_ages(ivy.model.skeleton, params.bark.colors.size(), params.crawl.radius);
  add_ivy_leaves(ivy.model, ivy.strands, params.leaves, under, seed.child("leaves"));
  if (params.tendrils) grow_tendrils(ivy, params, under, seed.child("tendrils"));
  return ivy;
}

}  // namespace frond
