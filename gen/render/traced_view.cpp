#include "render/traced_view.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "core/files.h"
#include "render/frame_files.h"
#include "render/place.h"
#include "render/scene_head.h"
#include "render/trace_state.h"

namespace frond {

namespace fs = std::filesystem;

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
  std::string head;
  std::ifstream scene(frames_ / (unfinished_frame(newest) + ".pov"));
  std::getline(scene, head);
  auto picture = traced_picture(newest, size_, read_scene_head(head).tone);
  if (!picture) return false;
  Result<std::string> png = png_text(*picture);
  return png && put_text(part_of(file_), file_, *png).empty();
}

}  // namespace frond
