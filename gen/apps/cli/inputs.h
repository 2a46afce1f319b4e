#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "cli/messages.h"
#include "core/assets.h"
#include "core/result.h"
#include "jobs/jobs.h"
#include "passes/traced_film.h"
#include "scene/preset.h"

namespace frond {

/// The folder that holds templates/, povinc/ and presets/: $FROND_HOME, or the one above the program's own.
Result<std::filesystem::path> home();

/// Where what may be made again is kept for this user: below $XDG_CACHE_HOME or ~/.cache.
std::filesystem::path cache_folder();

/// What turns a preset into a picture or a film, as it is typed here: scripts/render.sh in the folder of
/// Frond, its whole path elsewhere; empty where it is not there.
std::string render_command();

/// The shipped presets of that file's name or, where there is none, of the nearest, for a message: `; did you
/// mean "presets/trees/oak.json"?`. Empty where none is near.
std::string nearest_presets(const std::string& path);

/// Reads the preset that the command line names, with its overrides.
Result<Preset> load_preset(const PresetArguments& arguments);

/// Whether frames are resolved from raw ones: those of the quality good are, where nothing else is asked for.
/// What is wrong where frames are asked to be resolved that cannot be.
Errors refuse_resolving(const Film& film, const std::optional<bool>& asked);
bool is_resolved(const Film& film, const std::optional<bool>& asked);

/// A scene made to be traced, with its sown models, whose files are kept in that folder.
Result<TracedFilm> traced_film(const Scene& scene, const std::filesystem::path& models);

/// The files that a preset or a grammar of that path may name; `named` is `--assets`.
Result<Assets> assets_of(const std::string& path, const std::optional<std::string>& named);

/// Whether a file holds a grammar rather than a preset: one of another tool, or JSON without organisms.
bool is_grammar(const std::string& path);

/// What the manifest says of the film in a folder.
Result<Manifest> manifest_in(const std::filesystem::path& folder);

/// A range as in `--frames 5-12` or `--frames 7`, within 1..count.
struct FrameRange {
  int first, last;
};
Result<FrameRange> read_frames(const std::string& text, int count);
/// The same of an option; where it is not given, the usual frames.
Result<FrameRange> read_frames(const std::optional<std::string>& text, int count, FrameRange usual);
/// One frame as in `--frame 7`; 0: the last.
Result<int> read_frame(int asked, int count);
/// The frames that are rendered for those: where they are resolved, those around them, too.
FrameRange drawn_frames(const Film& film, FrameRange wanted);

}  // namespace frond
