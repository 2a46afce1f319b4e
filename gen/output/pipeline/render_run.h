#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "jobs/jobs.h"
#include "pipeline/events.h"
#include "pipeline/write_film.h"
#include "render/frames_left.h"
#include "render/ninja.h"
#include "render/process.h"
#include "render/traced_view.h"

namespace frond {

/// How the frames of a folder are to be rendered.
struct RenderSettings {
  std::filesystem::path out;  ///< the folder that write_film() has written
  std::string format;         ///< of the film; empty: the usual
  int jobs = 1;               ///< processors
  int every = 1;              ///< each K-th frame first, then those between
  bool watch = false;         ///< shows what is traced in watch.png
  std::string ffmpeg = "ffmpeg";
};

/// Renders what write_film() has written and makes the film of it, as far as it is not there yet.
class RenderRun {
 public:
  /// `environment`: what ninja's commands are given.
  RenderRun(RenderSettings settings, std::vector<std::string> environment, Stop& stop, RunEvents& events);

  Outcome run();

  /// After a run that was done: the files made, in its folder, and how many frames were rendered for them.
  std::vector<std::string> results() const;
  int rendered() const { return left_ ? left_->done() : 0; }
  const Manifest& manifest() const { return manifest_; }

 private:
  Errors prepare();
  void remove_old_results();
  void find_what_to_do();
  void begin();
  Errors render_every_kth();
  Outcome end();
  Error lost_frames() const;
  /// Makes files. What cannot be made is noted in failed_.
  void make(const std::vector<std::string>& files);
  int all_frames() const;
  std::vector<std::string> pictures_of(int step) const;

  /// Says what comes when all frames are traced.
  void begin_last();
  void done(std::string_view what);
  void said(std::string line);
  void idle();

  RenderSettings settings_;
  Stop& stop_;
  RunEvents& events_;
  Ninja ninja_;
  std::vector<std::string> environment_;
  Manifest manifest_;
  std::vector<int> to_do_;
  std::optional<FramesLeft> left_;
  std::optional<TracedView> watched_;
  std::vector<std::string> failed_;
  bool gave_up_ = false, interrupted_ = false, disk_full_ = false;
  int faults_ = 0, to_resolve_ = 0;  // blocks of frames, of the latter
  double waits_since_ = 0;           // seconds
  Errors errors_;
};

/// Seconds by a clock that only goes on.
double seconds_now();

}  // namespace frond
