#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/render_run.h"
#include "pipeline/write_film.h"

namespace frond {

/// What came of a run.
struct RenderedFilm {
  Outcome outcome;
  std::vector<std::filesystem::path> results;  ///< the film and its contact sheet, or the still
};

/// The programs that render, by their names or paths, and the environment of what is started for them.
struct RenderPrograms {
  std::string povray, ffmpeg;

  /// $FROND_POVRAY and $FROND_FFMPEG, or the usual ones.
  static RenderPrograms usual();
  /// What is wrong with them: there is none, or no ffmpeg for a film.
  Errors missing(bool film) const;
  std::vector<std::string> environment(const std::filesystem::path& home) const;
};

/// Renders what write_film() has written in the folder of `settings`, as far as it is not there yet, makes
/// the film, and notes the pace of the preset in that file.
RenderedFilm render_written(const RenderSettings& settings, const std::filesystem::path& home,
                            const std::filesystem::path& preset, Stop& stop, RunEvents& events);

/// From a preset to a film or a still: writes the folder and renders it. What is finished there stays, and
/// the same call goes on from it. `settings.out` is the folder of `film`.
RenderedFilm render_film(const FilmFolder& film, RenderSettings settings, Stop& stop, RunEvents& events);

}  // namespace frond
