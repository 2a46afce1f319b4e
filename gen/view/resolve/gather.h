#pragma once

#include <span>
#include <vector>

#include "resolve/resolve.h"

namespace frond {

/// What counts as one surface, by the first of it: all organs of an organism do, all copies of a set, all
/// patches of grass; each stone and block is one of its own.
inline Thing surface_of(const Thing& thing) {
  bool own = thing.kind == ThingKind::body || thing.kind == ThingKind::stone;
  return {thing.kind, thing.owner, own ? thing.number : 0};
}

/// Metres; how far away what is no surface counts as being.
constexpr float kBackdropAway = 1e5f;

/// A sample of a raw frame, carried to the frame that is made.
struct RawSample {
  Vec2 place{0};  ///< in the picture, pixels
  float away = 0;
  Vec3 at{0}, normal{0};
  Vec3 light{0};
  Thing surface;
  int age = 0;  ///< frames: that of its raw frame from this one
  bool lit = false;
  float facing = 0;  ///< of what is lit, TracedFrame::facing()
};

/// Some rows of a picture.
struct RowBand {
  int first = 0, end = 0;

  int count() const { return end - first; }
  bool holds(int row) const { return row >= first && row < end; }
};

/// Samples by the pixel that they lie in, of the rows of a band.
class SampleGrid {
 public:
  SampleGrid(int width, int height, RowBand band, const std::vector<std::vector<RawSample>>& rows);

  int width() const { return width_; }
  int height() const { return height_; }
  std::span<const RawSample> in(int x, int y) const {
    if (!band_.holds(y)) return {};
    std::size_t i = cell(x, y);
    return std::span(samples_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

 private:
  std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y - band_.first) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_, height_;
  RowBand band_;
  std::vector<std::size_t> first_;
  std::vector<RawSample> samples_;
};

/// Makes pixels, one at a time.
class Gatherer {
 public:
  Gatherer(const SampleGrid& grid, const TracedFrame& now, const ResolveOptions& options)
      : grid_(grid), now_(now), options_(options) {}

  Vec3 pixel(int x, int y);
  /// How wide a point is blurred in the pixel made last, pixels: by what is sharpest of it, but for a few of
  /// its rays. 0 without a lens.
  float blur();

 private:
  /// A surface that a pixel shows.
  struct Shown {
    Thing surface;
    bool lit = false;
    float away = 0;
    Vec3 at{0}, normal{0};
    Vec2 place{0};     // mean of its rays
    float facing = 0;  // likewise
    int rays = 0;
  };

  float blur_of(const Shown& one) const;
  void find_shown(int x, int y);
  void add_ray(Vec2 place, int ray, float spread);
  /// The mean light of samples of a surface; false where there are none. Each pass takes more of them.
  bool gather(const Shown& one, int pass, Vec3& light);
  void turn_light(const Shown& one, float facing, Vec3& light);

  const SampleGrid& grid_;
  const TracedFrame& now_;
  const ResolveOptions& options_;
  std::vector<Shown> shown_;
  std::vector<const RawSample*> taken_;
};

}  // namespace frond
