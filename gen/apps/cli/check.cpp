#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/named.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/printable.h"
#include "scene/upgrade.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Writes a preset anew in today's form, where it is none yet, and says what changes.
void upgrade(const std::string& path, const std::optional<std::string>& assets) {
  Upgrade today = or_fail(upgraded(path, assets), kCouldNot);
  if (today.changes.empty()) return;
  // Behind a link stands the preset; and whoever may read and write it still may.
  std::error_code error;
  fs::path file = fs::canonical(path, error);
  fs::perms mode = fs::status(file, error).permissions();
  or_fail(write_file(file, today.text), kCouldNot);
  fs::permissions(file, mode, error);
  for (const Error& change : today.changes) put(printable(change) + "\n");
}

void check_one(const PresetArguments& preset, bool upgrading) {
  bool there = path_exists(preset.path);
  if (there && is_grammar(preset.path)) return check_grammar(preset);
  if (there && upgrading) upgrade(preset.path, preset.assets);
  Preset read = or_fail(load_preset(preset), kWrongInput);
  tell_notes(read.notes);
  if (read.old) tell_notes({old_form(preset.path)});
}

struct CheckArguments {
  std::vector<std::string> paths;
  PresetArguments common;  ///< what is set of all presets; its path is empty
  bool upgrading = false;
};

/// Tells of all; the exit code is that of the last in which something is wrong.
void check(const CheckArguments& arguments) {
  int result = kDone;
  for (const std::string& path : arguments.paths) try {
      PresetArguments preset = arguments.common;
      preset.path = path;
      check_one(preset, arguments.upgrading);
    } catch (const CommandEnd& end) {
      result = end.code;
    }
  if (result != kDone) throw CommandEnd{result};
}

}  // namespace

void add_check(CLI::App& app) {
  auto [command, to] = add_command(app, "check", "Tells what is wrong in presets", check);
  command->add_option("presets", to->paths, "JSON files, or names of Frond's presets")
      ->required()
      ->transform(named_by(&preset_named));
  command->add_flag("--upgrade", to->upgrading,
                    "Writes presets of earlier versions anew with the names that properties have today");
  add_sets(command, to->common.sets);
  add_assets(command, to->common.assets);
  command->footer(R"(A grammar is checked as one.

Examples:
  frond check presets/*.json
  frond check presets/reef.json --set /film/fps=12
  frond check --upgrade my_reef.json)");
}

}  // namespace frond
