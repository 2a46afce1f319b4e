#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "core/assets.h"
#include "core/result.h"
#include "pipeline/frame_range.h"
#include "scene/preset.h"
#include "scene/upgrade.h"

namespace frond {

/// The folder that holds templates/, povinc/ and presets/: $FROND_HOME, or the one above the program's own.
Result<std::filesystem::path> home();

/// What turns a preset into a picture or a film, as it is typed here: scripts/render.sh in the folder of
/// Frond, its whole path elsewhere; empty where it is not there.
std::string render_command();

/// The shipped presets of that file's name or, where there is none, of the nearest, for a message: `; did you
/// mean "presets/trees/oak.json"?`. Empty where none is near.
std::string nearest_presets(const std::string& path);

/// Fails where the file of a preset is not there, and names the nearest.
void refuse_missing(const PresetArguments& preset);

/// The folder that a film goes to: that which is asked for, or out/<preset name>, with an ending; and the
/// file that something else goes to, which is else <preset name><ending>.
std::filesystem::path out_folder(const std::string& asked, const PresetArguments& preset,
                                 std::string_view ending = "");
std::string out_file(const std::string& asked, const PresetArguments& preset, std::string_view ending);

/// Reads the preset that the command line names, with its overrides.
Result<Preset> load_preset(const PresetArguments& arguments);

/// What of a preset's file has another form today; `assets` is `--assets`.
Result<Upgrade> upgraded(const std::string& path, const std::optional<std::string>& assets);

/// A word about a preset of an earlier version, and what carries it over.
Error old_form(const std::string& path);

/// The files that a preset or a grammar of that path may name; `named` is `--assets`.
Result<Assets> assets_of(const std::string& path, const std::optional<std::string>& named);

/// Whether a file holds a grammar rather than a preset: one of another tool, or JSON without organisms.
bool is_grammar(const std::string& path);

}  // namespace frond
