#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "core/result.h"
#include "passes/traced_film.h"

// Resolve
// =======
// Makes the frames of a film of raw ones. A raw frame has one sample a pixel, in each frame elsewhere in the
// pixel (sample_shift()). Which surfaces a pixel shows, and how much of each, is known without shading: many
// rays are traced through it. The light of each surface is that of the raw samples of the same surface in the
// frames around, carried to this one by its exact motion; what lies in the sun and what in shade apart. The
// picture is their mean by what each covers.
//
// A raw still has four samples a pixel, and no frames around it. Raw frames are sharp and of one moment: the
// rays that are traced go through the camera's lens, and are spread over the time that its shutter is open.
//
// A frame is a pure function of the raw frames of its window; it depends neither on threads nor on which
// other frames were made.

namespace frond {

struct RawSample;

/// The light of a picture, linear; row by row from the top.
using LightPicture = std::vector<Vec3>;

struct ResolveOptions {
  int window = 4;      ///< raw frames before and after a frame that it is made of
  int side = 5;        ///< side * side rays are traced through a pixel that shows more than one surface
  double reach = 0.4;  ///< pixels, standard deviation of the weight of a sample by how far aside it lies
  double fade = 4;     ///< frames after which a sample counts for 1/e
  /// Light of other frames is kept within so many standard deviations of this frame's around it; 0: it is
  /// not.
  double clip = 0;
};

class Resolver {
 public:
  /// Gives the raw picture of a frame.
  using Source = std::function<Result<LightPicture>(int frame)>;

  /// Resolves a film that is raw. The scene, the film and what `source` refers to must outlive the resolver.
  Resolver(const Scene& scene, const TracedFilm& film, Source source, const ResolveOptions& options = {});
  ~Resolver();

  /// The picture of a frame. Frames made in order share what they are made of.
  Result<LightPicture> frame(int number);

  /// Gives so many rows of the raw picture of a still, from one on.
  using RowSource = std::function<Result<LightPicture>(int first, int count)>;
  /// Takes the next rows of a picture.
  using RowReceiver = std::function<Errors(const LightPicture& rows)>;
  /// The picture of a still without an aperture, the same, in bands of so many rows: no more of it is held.
  /// Rows of the raw one are asked for in order, some of them again in the next band.
  Errors still_in_bands(const RowSource& raw, int band, const RowReceiver& receive);

 private:
  struct Raw;

  Result<const TracedFrame*> traced(int number);
  Result<const Raw*> raw(int number);
  /// Which spots the samples of some rows of a raw frame show.
  std::unique_ptr<Raw> found_spots(int number, const TracedFrame& now, LightPicture light, int first) const;
  void add_rows(std::vector<std::vector<RawSample>>& rows, const Raw& raw, const TracedFrame& now,
                int age) const;
  Result<LightPicture> at_moment(int number, const TracedFrame& now, const ResolveOptions& options);

  const Scene& scene_;
  const TracedFilm& film_;
  Source source_;
  ResolveOptions options_;
  std::map<int, TracedFrame> traced_;
  std::map<int, std::unique_ptr<Raw>> raws_;
};

}  // namespace frond
