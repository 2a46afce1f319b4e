#include "organisms/ivy.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

/// Where the plants stand on the host.
std::vector<Start> starts_of(const IvyParams& params, const Host& host, const IvyRoots& roots, int count,
                             Seed seed) {
  std::vector<Start> starts;
  for (const Vec3& root : roots) starts.push_back({DVec3(root), DVec3(0)});
  int more = count - static_cast<int>(roots.size());
  if (more <= 0) return starts;
  std::vector<Start> others = starts_at_foot(host, more, params.above, params.facing, seed.child("foot"));
  // A host without a foot, such as a floating one, is rooted all round.
  if (others.empty() && roots.empty())
    others =
        starts_around(host, more, Vec3((host.low() + host.high()) / 2.0), host.size(), seed.child("around"));
  starts.insert(starts.end(), others.begin(), others.end());
  return starts;
}

/// Which colour of the bark each node has: the thicker, the older; the last is that of shoots.
std::vector<std::int32_t> bark_ages(const Skeleton& s, std::size_t colors, double radius) {
  std::vector<std::int32_t> age(s.size(), 0);
  auto last = static_cast<std::int32_t>(colors) - 1;
  for (std::size_t i = 0; i < s.size() && last > 0; ++i) {
    double share = std::clamp((s.radius[i] / radius - 0.6) / 1.8, 0.0, 0.999);
    age[i] = last - static_cast<std::int32_t>(share * (last + 1));
  }
  return age;
}

}  // namespace

Result<Ivy> grow_ivy(const IvyParams& params, const Surface& surface, const IvyRoots& roots, int count,
                     double ground, Seed seed) {
  Result<Host> host = Host::build(surface, "what the ivy grows on");
  if (!host) return host.errors();
  Crawl crawl = params.crawl;
  if (!std::isfinite(crawl.low.y)) crawl.low.y = static_cast<float>(ground + crawl.radius);
  std::vector<Start> starts = starts_of(params, *host, roots, count, seed);
  Ivy ivy;
  ivy.strands = grow_strands(*host, starts, crawl, seed.child("crawl"));
  if (ivy.strands.size() < 2)
    return Error{
        "", "finds no place to root; expected place.at near what it grows on, or another above and facing"};
  ivy.model.skeleton = ivy.strands.skeleton;
  ivy.model.color = bark_ages(ivy.model.skeleton, params.bark.colors.size(), crawl.radius);
  add_ivy_leaves(ivy.model, ivy.strands, params.leaves, seed.child("leaves"));
  return ivy;
}

}  // namespace frond
