#include "studio/answers.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Answers, PlacesInAListCountFromZeroAndAreWhole) {
  EXPECT_EQ(index_in({{"entry", 0}}, "entry", 7), 0u);
  EXPECT_EQ(index_in({{"entry", 3}}, "entry", 7), 3u);
  EXPECT_EQ(index_in({{"plant", 3}}, "entry", 7), 7u);
  for (const Json& wrong : {Json(-1), Json(0.5), Json("0"), Json(nullptr), Json(1e300)})
    EXPECT_THROW(index_in({{"entry", wrong}}, "entry", 7), WrongQuestion) << wrong;
}

}  // namespace
}  // namespace frond
