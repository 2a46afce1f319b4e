#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/result.h"
#include "images/png_samples.h"
#include "images/raster.h"

// Pictures that are too large to be held whole, a band of rows at a time.

namespace frond {

inline constexpr int kLongestRow = 65'536;  ///< pixels of what is read or written in bands, and as many rows

/// Reads a PNG file of 8 or 16 bits a sample, without a table of colours, from the top down; of one that is
/// interlaced all rows at once. The bytes must outlive it.
class PngRows {
 public:
  static Result<PngRows> open(std::string_view png);
  PngRows(PngRows&&) noexcept;
  PngRows& operator=(PngRows&&) noexcept;
  ~PngRows();

  int width() const;
  int height() const;
  int channels() const;
  /// The number of rows read so far.
  int done() const;

  /// Reads so many rows more; there must be as many left.
  Result<PngSamples> next(int rows);
  /// Reads so many rows more as linear light, as read_linear_png() has them.
  Result<LinearRaster> next_linear(int rows, bool opacity);

 private:
  struct Reader;
  explicit PngRows(std::unique_ptr<Reader> reader);
  std::unique_ptr<Reader> reader_;
};

/// Writes a PNG file from the top down.
class PngWriter {
 public:
  /// Begins a picture of the size and kind of `like`, whose `data` is not looked at. A compression of 3 takes
  /// a third of the time of zlib's usual 6, for a tenth more bytes.
  explicit PngWriter(const PngSamples& like, int compression = 3);
  PngWriter(PngWriter&&) noexcept;
  PngWriter& operator=(PngWriter&&) noexcept;
  ~PngWriter();

  /// Adds rows of the same width and kind.
  void add(const PngSamples& rows);
  /// The bytes of the file, once all rows were added.
  Result<std::string> finish();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace frond
