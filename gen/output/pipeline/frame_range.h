#pragma once

#include <optional>
#include <string>

#include "core/result.h"
#include "estimate/estimate_cost.h"
#include "settings/scene_setup.h"

namespace frond {

/// Whether frames are resolved from raw ones: those of the quality good are, where nothing else is asked for.
bool is_resolved(const Film& film, const std::optional<bool>& asked);
/// What is wrong where frames are asked to be resolved that cannot be.
Errors refuse_resolving(const Film& film, const std::optional<bool>& asked);

/// A range as in `--frames 5-12` or `--frames 7`, within 1..count.
Result<FrameRange> read_frames(const std::string& text, int count);
/// The range that an option gives; where it is not given, the usual frames.
Result<FrameRange> read_frames(const std::optional<std::string>& text, int count, FrameRange usual);
/// One frame as in `--frame 7`; 0: the last.
Result<int> read_frame(int asked, int count);
/// The frames that are rendered for those: where they are resolved, those around them, too.
FrameRange drawn_frames(const Film& film, FrameRange wanted);

}  // namespace frond
