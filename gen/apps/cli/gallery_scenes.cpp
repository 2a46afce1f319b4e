#include "cli/gallery_scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/inputs.h"
#include "core/content.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/text.h"
#include "export/macros.h"
#include "film/scene_content.h"
#include "render/gallery.h"
#include "render/process.h"
#include "render/scene_head.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

MacroFiles macro_files(const fs::path& root) {
  MacroFiles files;
  for (const fs::path& file : files_in(root / "povinc"))
    if (Result<std::string> text = read_file(file); text && file.extension() == ".inc")
      files.emplace_back(file.filename().string(), std::move(*text));
  return files;
}

/// The line of a build.ninja that says how POV-Ray is called.
std::string flags_of(const fs::path& film) {
  Result<std::string> jobs = read_file(film / "build.ninja");
  for (const std::string& line : split(jobs ? *jobs : "", '\n'))
    if (line.starts_with("flags = ")) return line;
  return {};
}

}  // namespace

Result<std::string> scene_id(const fs::path& root, const fs::path& folder,
                             const std::vector<fs::path>& scenes) {
  Result<SceneContent> content = scene_content(folder, scenes);
  if (!content) return content.errors();
  std::string macros = macros_reached(macro_files(root), fmt::format("{}", fmt::join(content->words, " ")));
  return content_id(content->id + flags_of(folder.parent_path()) + macros);
}

std::vector<fs::path> scenes_of(const fs::path& film, int frame) {
  std::vector<fs::path> scenes{frame_name(frame) + ".pov"};
  Result<std::string> text = read_file(film / "frames" / scenes[0]);
  int exposures = text ? read_scene_head(*text).exposures : 1;
  for (int exposure = 2; exposure <= exposures; ++exposure)
    scenes.emplace_back(exposure_name(frame, exposure) + ".pov");
  return scenes;
}

std::string source_id(const fs::path& root, const std::vector<Still>& stills) {
  std::string all;
  auto add = [&all](const fs::path& file) {
    Result<std::string> text = read_file(file);
    all += fmt::format("{} {}\n", file.string(), text ? content_id(*text) : "none");
  };
  add(own_program());
  for (const char* folder : {"povinc", "templates"})
    for (const fs::path& file : files_in(root / folder)) add(file);
  for (const Still& still : stills) {
    PresetArguments arguments;
    arguments.path = still.preset.string();
    arguments.sets = still.sets;
    Result<Preset> preset = load_preset(arguments);
    if (!preset) return {};
    all += fmt::format("{} {} {} {}\n", still.frame, fmt::join(still.size, "x"), still.quality,
                       fmt::join(still.sets, " "));
    add(still.preset);
    for (const fs::path& file : preset->files) add(file);
  }
  return content_id(all);
}

fs::path scene_ids_file(const fs::path& root) { return root / "docs" / "gallery" / "scenes.txt"; }

Errors note_scene_id(const fs::path& root, const std::string& name, const std::string& id) {
  fs::path file = scene_ids_file(root);
  FolderLock alone(file.parent_path());
  Result<std::string> text = read_file(file);
  SceneIds ids = read_scene_ids(text ? *text : "");
  ids[name] = id;
  Result<bool> written = write_file(file, scene_ids_text(ids));
  return written ? Errors{} : written.errors();
}

}  // namespace frond
