#include "cli/check.h"

#include <fmt/format.h>

#include <memory>

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

/// Writes a preset anew in today's form, where it is none yet, and says what changes; kDone or why not.
int upgrade(const std::string& path, const std::optional<std::string>& assets) {
  Result<Upgrade> today = upgraded(path, assets);
  if (!today) return fail(today.errors(), kCouldNot);
  if (today->changes.empty()) return kDone;
  // Behind a link stands the preset; and whoever may read and write it still may.
  std::error_code error;
  fs::path file = fs::canonical(path, error);
  fs::perms mode = fs::status(file, error).permissions();
  if (Result<bool> written = write_file(file, today->text); !written)
    return fail(written.errors(), kCouldNot);
  fs::permissions(file, mode, error);
  for (const Error& change : today->changes) put(printable(change) + "\n");
  return kDone;
}

/// `common` is what is set of all presets; its path is empty.
int check(const std::vector<std::string>& paths, const PresetArguments& common, bool upgrading) {
  int result = kDone;
  for (const std::string& path : paths) {
    PresetArguments named = common;
    named.path = path;
    std::error_code error;
    if (fs::exists(path, error) && is_grammar(path)) {
      if (int code = check_grammar(named); code != kDone) result = code;
      continue;
    }
    if (upgrading && fs::exists(path, error)) {
      if (int code = upgrade(path, common.assets); code != kDone) {
        result = code;
        continue;
      }
    }
    Result<Preset> preset = load_preset(named);
    if (!preset) {
      result = fail(preset.errors(), kWrongInput);
      continue;
    }
    tell_notes(preset->notes);
    if (preset->old) tell_notes({old_form(path)});
  }
  return result;
}

}  // namespace

void add_check(CLI::App& app, int& result) {
  auto paths = std::make_shared<std::vector<std::string>>();
  auto* command = app.add_subcommand("check", "Tells what is wrong in presets");
  auto common = std::make_shared<PresetArguments>();
  auto upgrading = std::make_shared<bool>(false);
  command->add_option("presets", *paths, "JSON files, or names of Frond's presets")
      ->required()
      ->transform(named_by(&preset_named));
  command->add_flag("--upgrade", *upgrading,
                    "Writes presets of earlier versions anew with the names that properties have today");
  add_sets(command, common->sets);
  add_assets(command, common->assets);
  command->footer(
      "A grammar is checked as one.\n\nExamples:\n  frond check presets/*.json\n"
      "  frond check presets/reef.json --set /film/fps=12\n  frond check --upgrade my_reef.json");
  command->callback([&result, paths, common, upgrading] { result = check(*paths, *common, *upgrading); });
}

}  // namespace frond
