#pragma once

#include "core/machine.h"
#include "scene/preset.h"

namespace frond {

/// Frames of a film, from 1 on, with the last.
struct FrameRange {
  int first = 1, last = 1;

  int count() const { return last - first + 1; }
};

/// What it will take to write a film's frames, estimated from the preset: nothing is grown but small samples,
/// and the ground is laid where it is small. Seconds and memory within about a factor of two, bytes of 1.5.
/// Seconds are of a processor as ours, user and system time over all threads.
struct CostEstimate {
  double organisms = 0, modules = 0, nodes = 0, organs = 0;  ///< of all that grows with the scene
  double copies = 0, models = 0;                             ///< of what is sown, and what they are copies of
  double crowd = 0;                                          ///< of the copies those that cover the land
  int frames = 0, exposures = 1;                             ///< of the film; scenes of each frame
  double frame_bytes = 0;    ///< of the text of one frame when all is grown, and of what it alone reads
  double shared_bytes = 0;   ///< of all files that frames share
  double ungrown_bytes = 0;  ///< by which all frames together are smaller, as not all has grown in each
  double scene_memory = 0, frame_memory = 0;  ///< bytes: while frames are written, and more for each at work
  double growth_memory = 0;                   ///< the most that is held before the first is written
  double growth_seconds = 0, frame_seconds = 0;  ///< before the frames; for each
  double picture_bytes = 0;                      ///< of one rendered picture
  double tracing_disk = 0;                       ///< bytes that POV-Ray takes more while it traces one
  double resolve_memory = 0;                     ///< bytes while a picture is made of raw ones, where it is
  double render_seconds = 0;                     ///< for POV-Ray to render one frame
  std::size_t largest = 0;                       ///< the organism that takes most

  /// How many frames are best written at a time, at least 1.
  int at_once(const Machine& machine) const;
  double memory(int at_once) const;
  /// Bytes on the disk: of the frames before they are rendered, and with their pictures.
  double written() const { return frames * frame_bytes - ungrown_bytes + shared_bytes; }
  double disk() const { return written() + frames * picture_bytes; }
  /// Seconds of a processor until all frames are written.
  double seconds() const { return growth_seconds + frames * frame_seconds; }
};

/// What it will take to grow a preset for a view in the studio: what stands, without its text, its light and
/// its pictures, which a view has none of or asks for later. Within about a factor of two.
struct ViewCostEstimate {
  double nodes = 0;
  double seconds = 0, longest = 0;  ///< of a processor as ours; of that, what one thread does alone
  double memory = 0;                ///< bytes
  std::size_t largest = 0;          ///< the organism that takes most

  /// Seconds until it is there, on so many processors.
  double wait(int threads) const;
};

/// The cost of a part of the preset's film. A derivation past its limits is an error.
Result<CostEstimate> estimate_cost(const Preset& preset, FrameRange part);

/// The cost of a view of the preset. A derivation past its limits is an error; entries of which there are
/// none to grow cost nothing.
Result<ViewCostEstimate> estimate_view_cost(const Preset& preset);

/// Why the machine cannot bear an estimated cost: the figures and what to change. Empty where it can.
Errors refuse(const CostEstimate& estimate, const Machine& machine);
Errors refuse(const ViewCostEstimate& estimate, const Machine& machine);

}  // namespace frond
