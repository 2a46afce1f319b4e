#pragma once

#include <array>
#include <filesystem>

#include "core/result.h"
#include "images/raster.h"

namespace frond {

/// traced_picture() as a PNG, in the tone that its scene asks for. An error where nothing is traced.
Result<std::string> traced_png(const std::filesystem::path& state, const std::filesystem::path& scene,
                               std::array<int, 2> size, const Raster* below = nullptr);

/// A PNG file that shows a picture while it is traced.
class TracedView {
 public:
  /// Shows in `file` pictures of that size, which POV-Ray draws in the folder `drawn` from the scenes in
  /// `frames`.
  TracedView(std::filesystem::path file, std::filesystem::path frames, std::filesystem::path drawn,
             std::array<int, 2> size)
      : file_(std::move(file)), frames_(std::move(frames)), drawn_(std::move(drawn)), size_(size) {}

  /// Writes the blocks traced so far of the picture that was worked on last: once a second, and less often
  /// where that takes long. `now`: seconds, by any clock. Returns whether it has written.
  bool look(double now);

 private:
  std::filesystem::path file_, frames_, drawn_;
  std::array<int, 2> size_;
  double next_ = 0;
};

}  // namespace frond
