#pragma once

#include "core/machine.h"
#include "scene/preset.h"

namespace frond {

/// What it will take to write a film's frames, foreseen from the preset: nothing is grown but small samples.
/// Within about a factor of two.
struct Foretold {
  double organisms = 0, modules = 0, nodes = 0, organs = 0;  ///< of all that grows with the scene
  double copies = 0, models = 0;                             ///< of what is sown, and what they are copies of
  int frames = 0;
  double frame_bytes = 0;                     ///< text of one frame when all is grown
  double shared_bytes = 0;                    ///< of all files that frames share
  double scene_memory = 0, frame_memory = 0;  ///< bytes: while frames are written, and more for each at work
  double growth_memory = 0;                   ///< the most that is held while it grows
  double growth_seconds = 0, frame_seconds = 0;  ///< of one thread; of each frame
  double picture_bytes = 0;                      ///< of one rendered picture, and of its soft light
  double render_seconds = 0;  ///< of one processor as ours, for POV-Ray to render one frame
  std::size_t largest = 0;    ///< the organism that takes most

  /// How many frames are best written at a time, at least 1.
  int at_once(const Machine& machine) const;
  double memory(int at_once) const;
  double disk() const { return frames * (frame_bytes + picture_bytes) + shared_bytes; }
  double seconds(int threads) const;
};

/// Of so many frames of the preset. A derivation past its limits is refused.
Result<Foretold> foretell(const Preset& preset, int frames);

/// Why the machine cannot bear it: the figures and what to change. Empty where it can.
Errors refuse(const Foretold& foretold, const Machine& machine);

}  // namespace frond
