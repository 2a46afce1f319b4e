#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"
#include "pipeline/events.h"
#include "pipeline/frame_range.h"
#include "render/descriptor.h"

namespace frond {

/// Tells other runs, as long as this object lives, that a run is at work in a folder: a shared lock on the
/// folder itself. Waits while another run tidies the folder up. Where the file system knows no locks, nobody
/// is ever alone.
class FolderInUse {
 public:
  /// Makes the folder where it is not there.
  explicit FolderInUse(const std::filesystem::path& folder);

  /// Whether no other run is at work in the folder. If so, others wait from now on.
  bool by_us_alone();

 private:
  Descriptor file_;
};

/// Holds the folder of a run as long as it lives; other runs wait. What this process starts holds it, too, so
/// that a run whose parent was killed is over before the next begins.
class RunLock {
 public:
  /// Makes the folder where it is not there, and waits for its turn.
  RunLock(const std::filesystem::path& out, RunEvents& events);

  const Errors& errors() const { return errors_; }

 private:
  Descriptor file_;
  Errors errors_;
};

/// Why nothing can be written to a folder, or to a file: a file, folder or permission that prevents it. Empty
/// where it can be written to.
Errors refuse_folder(const std::filesystem::path& folder);
Errors refuse_file(const std::filesystem::path& file);

/// What is wrong with a folder of frames that links elsewhere. Most files there are put in their place whole,
/// which leaves alone what a link points to; but ninja and the programs that it calls write to some by their
/// names (.ninja_log, .times, lists), and all frames go through the folder `frames`: no link may stand there.
Errors refuse_links(const std::filesystem::path& out);

/// An error where a path that is to be written to is a link; empty otherwise.
Errors refuse_link(const std::filesystem::path& path);

/// Removes the pictures of earlier runs that do not count as done, so that they are made again: frames of the
/// range that are not whole or not of the size of the film, and a damaged still or contact sheet. Gives those
/// that are damaged. An error where a folder stands in the place of a picture.
Result<std::vector<std::filesystem::path>> remove_damaged(const std::filesystem::path& out, FrameRange range,
                                                          const Film& film);

/// Removes what no frame reads any more, pictures and models of earlier runs, and what killed runs have left
/// half written, and exposures beyond those that make a frame. Frames stay: those of another range may be
/// asked for again.
void tidy(const std::filesystem::path& out, const std::set<std::string>& needed, int exposures);

}  // namespace frond
