#include "geometry/far.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vec.h"

namespace frond {
namespace {

TEST(Bends, OfAStraightChainAreItsEnds) {
  std::vector<glm::vec4> chain;
  for (int i = 0; i < 9; ++i) chain.emplace_back(0, i, 0, 0.1f - 0.01f * static_cast<float>(i));
  std::vector<char> marks(9, 0);
  mark_bends(chain, 1e-4f, marks);
  EXPECT_EQ(marks, std::vector<char>({1, 0, 0, 0, 0, 0, 0, 0, 1}));
  chain[4].w += 0.05f;  // a knot
  mark_bends(chain, 1e-4f, marks);
  EXPECT_EQ(marks[4], 1);
}

TEST(Bends, LeaveNothingFartherFromTheLineThanAsked) {
  std::vector<glm::vec4> chain;
  for (int i = 0; i <= 200; ++i) chain.emplace_back(std::sin(0.07 * i), 0.02 * i, std::cos(0.05 * i), 0.01);
  std::vector<char> marks(chain.size(), 0);
  mark_bends(chain, 0.01f, marks);
  std::size_t count = 0;
  for (std::size_t i = 0, from = 0; i < chain.size(); ++i) {
    if (!marks[i]) continue;
    ++count;
    Vec3 a(chain[from]), b(chain[i]);
    for (std::size_t k = from; k < i; ++k) {
      float along = std::clamp(glm::dot(Vec3(chain[k]) - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
      EXPECT_LE(glm::distance(Vec3(chain[k]), a + along * (b - a)), 0.0101f);
    }
    from = i;
  }
  EXPECT_LT(count, 60u);
}

}  // namespace
}  // namespace frond
