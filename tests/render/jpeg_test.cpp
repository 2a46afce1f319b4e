#include "render/jpeg.h"

#include <gtest/gtest.h>

namespace frond {

TEST(Jpeg, PicturesAreLaidRowByRow) {
  EXPECT_EQ(sheet_layout(1, 1, {8, 4}), "0_0");
  EXPECT_EQ(sheet_layout(5, 2, {100, 50}), "0_0|104_0|0_54|104_54|0_108");
}

}  // namespace frond
