#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/result.h"
#include "images/differ.h"

namespace frond {

/// How much two pictures, films or folders of frames differ.
struct Measured {
  Differ differ;
  bool film = true;             ///< or a picture
  std::vector<int> numbers;     ///< of the frames that both have
  int left_out = 0;             ///< how many frames only one of them has
  Errors errors;                ///< why they could not be measured
  ExitCode code = kWrongInput;  ///< where there are errors
};

/// A film that is measured.
struct MeasuredFilm {
  std::filesystem::path file;
  std::array<int, 2> size{};  ///< pixels
  std::string rate;           ///< frames a second, as ffmpeg writes it
};

/// The folder that holds the pictures frame_0001.png and so on of a run, itself or its `frames`; empty where
/// there are none.
std::filesystem::path folder_of_frames(const std::filesystem::path& folder);

/// PNG files of one size.
Measured measure_pictures(const std::filesystem::path& a, const std::filesystem::path& b);

/// The pictures of two such folders that have one name.
Measured measure_frames(const std::filesystem::path& a, const std::filesystem::path& b);

/// Two films of one size, as far as both go.
Measured measure_films(const MeasuredFilm& a, const MeasuredFilm& b);

/// What was measured, as words and as JSON with a line end.
std::string figures_in_words(const Measured& measured);
std::string figures_as_json(const Measured& measured);

}  // namespace frond
