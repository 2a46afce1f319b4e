#include "estimate/estimate_pictures.h"

#include <algorithm>
#include <cmath>

#include "settings/forest.h"
#include "settings/meadow.h"

namespace frond {

double frames_ungrown(const Film& film, const Growth& growth, FrameRange part) {
  constexpr double kNodes = 1.5;  // by this power of its growth the nodes of an organism become more
  double sum = 0;
  for (int frame = part.first; frame <= part.last && growth.duration > 0; ++frame)
    sum += 1 - std::pow(std::min(1.0, growth_front(growth, film.time(frame))), kNodes);
  return sum;
}

MaskCostEstimate estimate_masks(const Preset& preset) {
  constexpr double kRead = 4;  // of a pixel, of four channels
  MaskCostEstimate masks;
  auto add = [&](const Mask& mask) {
    if (mask.empty()) return;
    auto pixels = static_cast<double>(mask.grey->size());
    masks.held += kMaskHeld * pixels;
    masks.read = std::max(masks.read, kRead * pixels);
  };
  add(preset.setup.block<Meadow>().lawn.map);
  add(preset.setup.block<Forest>().moss_map);
  add(preset.setup.snow.depth_map);
  for (const Organism& organism : preset.organisms)
    if (organism.sown) add(organism.sown->where.map);
  return masks;
}

double estimate_tracing_disk(const Film& film) {
  constexpr double kNoted = 20;                // of a pixel: what has been traced is noted, to go on from
  constexpr double kHeld = 128 * 1024 * 1024;  // of a picture, in memory; a larger one has a file of its own
  double noted = kNoted * film.drawn_size()[0] * film.drawn_size()[1];
  return noted > kHeld ? 2 * noted : noted;
}

double estimate_resolving(const Preset& preset) {
  constexpr double kSampleHeld = 220;  // of a raw sample: its light, what it shows, and where that is now
  constexpr int kFrames = 9;           // raw ones that a frame is made of
  const Film& film = preset.film;
  if (!film.raw) return 0;
  double samples = static_cast<double>(film.drawn_size()[0]) * film.drawn_size()[1];
  // A still that is seen without a lens is made in bands, of a raw file that is held as it is.
  if (film.frames == 1 && !preset.setup.camera.aperture && samples > kResolvedWhole)
    return kSampleHeld * kResolvedWhole + 3 * samples;
  return kSampleHeld * samples * std::min(film.frames, kFrames);
}

}  // namespace frond
