#pragma once

#include <string_view>
#include <vector>

#include "core/result.h"
#include "images/raster.h"

/// How much pictures differ, and films, in steps of 255 of sRGB values, which the eye sees as about equal.
namespace frond {

/// A picture as it is seen: red, green and blue of each pixel in sRGB, 0 to 255, rows from the top down. Of
/// 16 bits per channel they have fractions. What lets light through stands before black.
struct SeenPicture {
  int width = 0, height = 0;
  std::vector<float> values;
};

SeenPicture seen(const Raster& raster);
SeenPicture seen(const LinearRaster& raster);

/// Reads a PNG file of any kind, of 8 or 16 bits per channel.
Result<SeenPicture> read_seen_png(std::string_view bytes);

struct Difference {
  double error = 0;    ///< root of the mean square over all pixels and channels, in steps of 255
  double maximum = 0;  ///< of all pixels and channels, in steps of 255
  double share = 0;    ///< of pixels of which a channel is off by more than 8 steps, 0 to 1
};

/// Sums up the difference of two films, frame by frame, none of which is kept; of two pictures it is that of
/// films of one frame. Takes 8 bytes a pixel and channel.
class Differ {
 public:
  /// The next frame of both, of one size, which all frames have. Gives the difference of these two.
  Difference add(const SeenPicture& a, const SeenPicture& b);

  int frames() const { return frames_; }
  /// How many frames differ at all.
  int differing() const { return differing_; }
  /// Which frame differs most, from 1 on, the first of equal ones, and by how much; 0 where none differs.
  int worst() const { return worst_; }
  double worst_error() const { return worst_error_; }
  /// Over all frames.
  Difference total() const;
  /// How much the difference changes over time: of each pixel and channel the standard deviation of A - B
  /// over the frames, of which the root of the mean square, in steps of 255. What stays, as a film that is
  /// brighter throughout, adds nothing; of one frame it is 0.
  double flicker() const;

 private:
  int frames_ = 0, differing_ = 0, worst_ = 0;
  double worst_error_ = 0;
  double squares_ = 0, maximum_ = 0, shares_ = 0;  ///< sums over the frames, and the greatest
  std::vector<float> means_, spreads_;             ///< of A - B: mean, sum of squares about it
};

}  // namespace frond
