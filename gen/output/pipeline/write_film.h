#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "jobs/jobs.h"
#include "pipeline/events.h"
#include "pipeline/frame_range.h"
#include "scene/scene.h"

namespace frond {

/// What is written in the folder of a film, for POV-Ray, ffmpeg and ninja.
struct FilmFolder {
  const Preset& preset;           ///< its film says whether frames are resolved from raw ones
  std::filesystem::path file;     ///< of the preset; tells by which pace its cost is reckoned
  FrameRange range;               ///< frames to be made
  std::filesystem::path home;     ///< the folder of Frond
  std::filesystem::path out;      ///< where to write
  std::filesystem::path program;  ///< `frond`, which build.ninja calls
  /// The words that say to `frond resolve` which preset it is, as seen from `out`.
  std::vector<std::string> resolve;
  std::vector<Manifest::Budget> budgets;  ///< as they were counted
  bool alone = false;                     ///< none of the frames around, with which raw ones are resolved
};

/// How a run went.
struct Outcome {
  Errors errors;               ///< empty: well
  bool of_the_preset = false;  ///< it is the preset that they are about
  bool stopped = false;        ///< it was cancelled

  bool well() const { return errors.empty() && !stopped; }
};

/// What tells the events of a run how far a scene is.
ProgressSink sink_of(RunEvents& events);

/// Grows the scene and writes its frames, what they include, and build.ninja and manifest.json, which say how
/// they are rendered. What earlier runs have left there that nothing needs is removed. Nothing is grown that
/// the machine could not bear.
Outcome write_film(const FilmFolder& film, RunEvents& events);

/// Writes build.ninja and manifest.json alone, for pictures that come from elsewhere.
Outcome write_film_only(const FilmFolder& film, RunEvents& events);

/// Reads the preset once more, with these overrides besides.
using ReadAgain = std::function<Result<Preset>(const std::vector<std::string>& sets)>;

/// Budgets of growth that a preset gives in seconds, as numbers of internodes: those that the film in a
/// folder was generated with before, others by the pace at which one such tree grows now. Sets them in the
/// preset, and notes each.
Result<std::vector<Manifest::Budget>> count_budgets(Preset& preset, const ReadAgain& again,
                                                    const std::filesystem::path& out, RunEvents& events);
/// What sets such a budget, as `--set` has it.
std::string set_of(const Manifest::Budget& budget);

}  // namespace frond
