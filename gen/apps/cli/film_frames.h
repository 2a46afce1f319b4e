#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"
#include "images/raster.h"
#include "render/process.h"

namespace frond {

/// The frames of a film, one after the other, as ffmpeg decodes them.
class FilmFrames {
 public:
  /// `size` in pixels; `rate` is the film's own in frames a second, as ffmpeg writes it: each frame is given
  /// once, whatever the film's clock says.
  FilmFrames(const std::filesystem::path& film, std::array<int, 2> size, const std::string& rate);
  ~FilmFrames();
  FilmFrames(const FilmFrames&) = delete;
  FilmFrames& operator=(const FilmFrames&) = delete;

  /// The next frame; nothing at the end, and where there is none to be had, see errors().
  std::optional<Raster> next();

  /// Why the film ended, or did not begin, where it is damaged.
  const Errors& errors() const { return errors_; }

 private:
  std::string name_;
  std::array<int, 2> size_;
  OutputCapture said_;
  pid_t process_ = -1;
  int file_ = -1;
  Errors errors_;
};

}  // namespace frond
