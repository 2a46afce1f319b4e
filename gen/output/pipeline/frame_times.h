#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "jobs/jobs.h"
#include "pipeline/events.h"

namespace frond {

/// A line of .times: what a frame took of processors.
struct FrameTime {
  std::string name;  ///< "frame_0001"
  double seconds = 0;
};

/// Those that are noted in a folder, in the order in which the frames were done.
std::vector<FrameTime> read_times(const std::filesystem::path& out);

/// After a run that has rendered so many frames: says what the slowest took, and notes the pace for what is
/// estimated for the next of that preset. The times behind the first `before` are its own.
void note_times(const std::filesystem::path& out, std::size_t before, const Manifest& manifest, int rendered,
                const std::filesystem::path& preset, RunEvents& events);

/// Draws nodes, bytes and seconds of the frames in a folder as an SVG.
Errors write_plot(const std::filesystem::path& out, const Manifest& manifest,
                  const std::filesystem::path& file);

}  // namespace frond
