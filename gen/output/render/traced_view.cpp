#include "render/traced_view.h"

#include <algorithm>
#include <string>

#include "core/files.h"
#include "render/frame_files.h"
#include "render/place.h"
#include "render/scene_head.h"
#include "render/trace_state.h"

namespace frond {

namespace fs = std::filesystem;

Result<std::string> traced_png(const fs::path& state, const fs::path& scene, std::array<int, 2> size,
                               const Raster* below) {
  auto picture = traced_picture(state, size, scene_head_of(scene).tone, below);
  if (!picture) return Error{state.string(), "nothing is traced yet"};
  return png_text(*picture);
}

bool TracedView::look(double now) {
  constexpr double kPause = 1,
                   kPauseAPixel = 1e-6;  // seconds: a large picture takes some to read and to write
  if (now < next_) return false;
  next_ = now + std::max(kPause, kPauseAPixel * size_[0] * size_[1]);
  fs::path newest;
  fs::file_time_type changed = fs::file_time_type::min();
  std::error_code error;
  for (const fs::path& path : files_in(drawn_)) {
    if (path.extension() != ".kept") continue;
    auto time = fs::last_write_time(path, error);
    if (!error && time > changed) newest = path, changed = time;
  }
  if (newest.empty()) return false;
  Result<std::string> png = traced_png(newest, frames_ / (unfinished_frame(newest) + ".pov"), size_);
  return png && put_text(part_of(file_), file_, *png).empty();
}

}  // namespace frond
