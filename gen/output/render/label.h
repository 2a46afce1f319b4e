#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

/// The lines of what is to stand below a picture so many pixels wide. A character is at most 0.64 of its size
/// wide; three blanks part a text.
std::vector<std::string> label_lines(std::string_view text, int width);

/// Labels below pictures of one width, for ffmpeg. Their text goes through files, so none is ever part of a
/// filter.
class Labels {
 public:
  /// The files are written to a folder that exists, where ffmpeg must run.
  explicit Labels(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Notes a text under a name of letters and digits.
  Errors add(const std::string& name, std::string_view text, int width);

  /// The filter that puts it below a picture, once all are there: as much room is left below each.
  std::string filter(const std::string& name) const;

 private:
  struct Label {
    std::string name;
    std::size_t lines = 0;
  };

  std::filesystem::path folder_;
  std::vector<Label> labels_;
  std::size_t most_ = 1;  // lines of one
};

}  // namespace frond
