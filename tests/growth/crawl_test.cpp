#include "growth/crawl.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "growth/meshes.h"

namespace frond {
namespace {

Host built(const Surface& s) { return std::move(*Host::build(s)); }

/// What is wrong with strands on a host (of the closed meshes here): far from it, within it, through it.
struct Faults {
  std::size_t far = 0, within = 0, through = 0, floating = 0;
};

Faults faults(const Strands& s, const Host& host) {
  Faults f;
  for (std::size_t i = 0; i < s.size(); ++i) {
    DVec3 at(s.skeleton.position[i]);
    double off = host.closest(at)->distance, radius = s.skeleton.radius[i];
    if (!s.hanging[i]) {
      f.far += off > radius + 0.01 * host.size();
      f.floating += off > 1.2 * radius;
    }
    f.within += host.inside(at);
    std::int32_t p = s.skeleton.parent[i];
    if (p < 0) continue;
    DVec3 from(s.skeleton.position[p]);
    auto in = host.crossing(from, at);
    if (!in) continue;
    auto out = host.crossing(at, from);
    DVec3 a = from + (at - from) * in->share, b = out ? at + (from - at) * out->share : at;
    double deepest = 0;
    for (int k = 0; k <= 10; ++k)
      deepest = std::max(deepest, host.closest(a + (b - a) * (k / 10.0))->distance);
    f.through += deepest > std::max<double>(radius, s.skeleton.radius[p]);
  }
  return f;
}

TEST(Crawl, KeepsToEverySurface) {
  struct Case {
    const char* name;
    Surface surface;
  };
  for (const Case& c : {Case{"ball", ball(1, 160, 80)},
                        {"ring", ring(1, 0.3, 160, 80)},
                        {"cube", cube(1, 10)},
                        {"rock", bumpy_rock()},
                        {"thin wall", thin_wall()},
                        {"openings", wall_with_openings()},
                        {"corner", corner()}}) {
    SCOPED_TRACE(c.name);
    Host host = built(c.surface);
    Strands s = grow_strands(host, starts_around(host, 12, Vec3(0), 10, Seed{3}), {}, Seed{1});
    ASSERT_EQ(s.skeleton.check(), "");
    EXPECT_GT(s.size(), 3000u);
    Faults f = faults(s, host);
    EXPECT_EQ(f.far, 0u);
    EXPECT_EQ(f.within, 0u);
    EXPECT_EQ(f.through, 0u);
    EXPECT_EQ(f.floating, 0u);
  }
}

TEST(Crawl, IsTheSameAtAnyNumberOfThreads) {
  Host host = built(bumpy_rock(5));
  auto starts = starts_at_foot(host, 20, 0.02, Vec3(0), Seed{3});
  limit_threads(1);
  Strands one = grow_strands(host, starts, {}, Seed{2});
  limit_threads(0);
  Strands many = grow_strands(host, starts, {}, Seed{2});
  EXPECT_EQ(one.skeleton.position, many.skeleton.position);
  EXPECT_EQ(one.skeleton.radius, many.skeleton.radius);
  EXPECT_EQ(one.skeleton.parent, many.skeleton.parent);
  EXPECT_EQ(one.hanging, many.hanging);
  Strands other = grow_strands(host, starts, {}, Seed{3});
  EXPECT_NE(one.skeleton.position, other.skeleton.position);
}

}  // namespace
}  // namespace frond
