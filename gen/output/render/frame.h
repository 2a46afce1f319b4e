#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

/// One frame, by POV-Ray.
///
/// The picture is seen whole or not at all, and has the same bytes however often its rendering was killed:
/// POV-Ray notes each block of pixels in a state file, and the next call goes on from there. The state bears
/// a hash of all that makes the picture, so that nothing of another scene, size or quality is taken for it.
///
/// Where motion is blurred, the picture is the mean light of several exposures, each a scene of its own:
/// frame_0001.pov, frame_0001_s2.pov and so on. Those that are drawn are kept until all are.
///
/// A scene is a program that may open files: POV-Ray is kept to the folders of the film and of the includes
/// (render/confine.h). Its own restrictions (povray.conf) are no help: in Debian's 3.7.0.10 the setting
/// "restricted" is read and never heeded.
namespace frond {

struct FrameJob {
  std::filesystem::path scene;     ///< a .pov
  std::filesystem::path picture;   ///< a .png, in the folder that holds what is unfinished, too
  std::array<int, 2> size{};       ///< pixels
  std::vector<std::string> flags;  ///< of POV-Ray, beside those of size and files
  std::filesystem::path home;      ///< the folder that holds povinc/ and scripts/povray.ini
  std::string povray = "povray";   ///< the program
  int threads = 1;                 ///< that trace it; no pixel depends on them
  bool confined = true;
};

/// Renders it, and adds a line to .times in the folder above that of the picture: the frame, milliseconds of
/// processor that it took, and its size. False where SIGTERM, SIGINT or SIGHUP stopped it. The process must
/// have one thread.
Result<bool> render_frame(const FrameJob& job);

}  // namespace frond
