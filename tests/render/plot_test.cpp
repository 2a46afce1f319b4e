#include "render/plot.h"

#include <gtest/gtest.h>

namespace frond {

TEST(Plot, ALineIsBrokenWhereNothingIsKnown) {
  PlotFrame frames[] = {{1, 10, 2e6, 1}, {2, 20, 4e6, {}}, {3, 0, 4e6, 2}};
  std::string text = plot_text(frames);
  EXPECT_NE(text.find("d=\"M60.0 80.0h.1L340.0 30.0L620.0 130.0\""), text.npos) << text;
  EXPECT_NE(text.find("d=\"M60.0 380.0h.1M620.0 330.0h.1\""), text.npos) << text;
  EXPECT_NE(text.find(">4 M</text>"), text.npos);
  EXPECT_NE(text.find("frames 1 to 3</text>"), text.npos);
}

TEST(Plot, OneFrameIsAPoint) {
  PlotFrame frame{7, 0, {}, {}};
  std::string text = plot_text(std::span(&frame, 1));
  EXPECT_NE(text.find("d=\"M60.0 130.0h.1\""), text.npos) << text;
  EXPECT_NE(text.find("class=\"line\" d=\"\""), text.npos);
}

}  // namespace frond
