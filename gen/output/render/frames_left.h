#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// How far the rendering of frames is, and how long it will take.
namespace frond {

/// A frame counts by a weight: half of it is the picture, as large in all frames, half the scene, by its
/// bytes. Of frames that are being traced counts the share that POV-Ray has noted, 20 bytes a pixel;
/// scripts/povray.ini spreads what is noted over the picture, so that a plain sky says nothing wrong of the
/// rest. Times are seconds by any clock.
class FramesLeft {
 public:
  /// The frames of these numbers, whose scenes lie in `frames`, are to be drawn in the folder `drawn`, so
  /// many at once, from `now` on.
  FramesLeft(const std::filesystem::path& frames, std::filesystem::path drawn, std::array<int, 2> size,
             const std::vector<int>& numbers, int at_once, double now);

  void frame_done(int number);

  /// Looks at what POV-Ray has noted of unfinished pictures.
  void look(double now);

  int done() const { return frames_done_; }
  bool reads() const { return !read_; }  ///< nothing has been traced yet
  int percent() const;
  double seconds_taken(double now) const { return now - began_; }

  /// The seconds that are left; nothing while there is no telling, as where all scenes are still read.
  std::optional<double> seconds_left(double now) const;

 private:
  struct Frame {
    double weight = 1;
    int exposures = 1;
  };

  std::filesystem::path folder_;
  double picture_bytes_, began_;
  int at_once_, frames_done_ = 0;
  std::map<std::string, Frame> frames_;  // by name
  double all_ = 0, done_ = 0, noted_ = 0;
  std::optional<double> noted_before_, read_;
};

/// Seconds as 3:07.
std::string clock_text(double seconds);

}  // namespace frond
