#include "organisms/ivy/ivy_rest.h"

#include <gtest/gtest.h>

#include "core/seed.h"
#include "crossings.h"
#include "masonry/wall_parts.h"

namespace frond {
namespace {

/// A leaf of one unit, in two triangles.
Surface square_leaf() {
  Surface s;
  s.position = {{-0.5f, 0, 0}, {0.5f, 0, 0}, {0.5f, 1, 0}, {-0.5f, 1, 0}};
  s.uv.resize(4);
  s.triangle = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

TEST(LieOn, NoEdgeGoesThroughWhatIsThinnerThanTheGapsOfItsPoints) {
  Surface fin;
  append_box(fin, Vec3(0, -0.5f, 0), Vec3(2, 1, 0.0004f));
  Result<TriangleSurface> built = TriangleSurface::build(fin);
  const TriangleSurface& host = *built;
  Feelers feelers = feelers_of(square_leaf(), 0.35f);
  constexpr float kSize = 0.1f;
  GroundHeight none;
  int lies = 0, pierced = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    auto random = [&](std::uint64_t k, double low, double high) {
      return static_cast<float>(Seed{5}.child(i).child(k).range(low, high));
    };
    // It points through the fin, more or less down.
    Rest rest{Vec3(random(0, -0.3, 0.3), random(1, -0.02, 0.05), random(2, 0.01, 0.06)),
              glm::angleAxis(random(3, -3, 3), Vec3(0, 1, 0)) *
                  glm::angleAxis(random(4, -2.6, -1.2), Vec3(1, 0, 0)) *
                  glm::angleAxis(random(5, -0.5, 0.5), Vec3(0, 1, 0))};
    auto goes_through = [&] {
      for (const auto& [from, to] : feelers.edges)
        for (const auto& [a, b, c] : host.triangles())
          if (meets_triangle(rest.foot + rest.turn * (kSize * from), rest.foot + rest.turn * (kSize * to), a,
                             b, c))
            return true;
      return false;
    };
    pierced += goes_through();
    if (!lie_on({host, none}, feelers, kSize, 0.3f, Vec3(0, 0, 1), rest)) continue;
    ++lies;
    EXPECT_FALSE(goes_through()) << i;
  }
  EXPECT_GT(pierced, 20);
  EXPECT_GT(lies, 50);
}

}  // namespace
}  // namespace frond
