#include "render/bands.h"

#include <gtest/gtest.h>

#include <vector>

#include "images/png_samples.h"
#include "images/raster.h"

namespace frond {

TEST(Bands, CoverThePictureAndEndWhereBlocksDo) {
  for (int height : {1, 31, 32, 33, 150, 480})
    for (int bands : {1, 2, 4, 5}) {
      int row = 0;
      for (int band = 1; band <= bands; ++band) {
        BandRows rows = band_rows(bands, band, height);
        EXPECT_EQ(rows.top, row) << height << ", " << band << " of " << bands;
        EXPECT_TRUE(rows.below % 32 == 0 || rows.below == height);
        row = rows.below;
      }
      EXPECT_EQ(row, height);
    }
}

TEST(Bands, AreJoinedToTheWholePicture) {
  Raster whole(5, 100, 3);
  for (std::size_t i = 0; i < whole.data.size(); ++i) whole.data[i] = static_cast<std::uint8_t>(i * 7);
  std::vector<std::string> pngs;
  constexpr int kBands = 3;
  for (int band = 1; band <= kBands; ++band) {
    Raster part(5, 100, 3);
    BandRows rows = band_rows(kBands, band, whole.height);
    for (std::size_t i = part.index(0, rows.top); i < part.index(0, rows.below); ++i)
      part.data[i] = whole.data[i];
    pngs.push_back(with_density(png_text(part).value(), 300));
  }
  Result<std::string> joined = join_bands(pngs);
  ASSERT_TRUE(joined);
  EXPECT_EQ(read_png(*joined)->data, whole.data);
  std::size_t head = pngs[0].find("IDAT");
  EXPECT_EQ(joined->substr(0, head - 4), pngs[0].substr(0, head - 4)) << "says what its bands say";
  pngs[1] = png_text(Raster(5, 99, 3)).value();
  EXPECT_FALSE(join_bands(pngs));
  pngs[1] = "no picture";
  EXPECT_FALSE(join_bands(pngs));
}

}  // namespace frond
