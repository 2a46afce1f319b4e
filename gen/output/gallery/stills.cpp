#include "gallery/stills.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/content.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/text.h"
#include "export/macros.h"
#include "film/scene_content.h"
#include "gallery/gallery_list.h"
#include "render/process.h"
#include "render/scene_head.h"
#include "scene/preset.h"

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

Result<Preset> preset_of(const Still& still) {
  Result<std::string> text = read_file(still.preset);
  return text ? read_preset(*text, still.preset.string(), still.sets) : text.errors();
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

Errors call_for(const fs::path& root, std::vector<std::string> words, const fs::path& folder) {
  Command command;
  std::string what = words[0];
  command.words = std::move(words);
  command.environment = {"FROND_HOME=" + root.string()};
  command.folder = folder;
  command.out = 2;
  command.end_with = SIGTERM;
  Result<int> code = run(command);
  if (!code) return code.errors();
  return *code == 0 ? Errors{} : Errors{error_at("", "{} ended with exit code {}", what, *code)};
}

Errors write_scene(const fs::path& root, const Still& still, const fs::path& folder) {
  std::vector<std::string> words{own_program().string(),
                                 "generate",
                                 still.preset.string(),
                                 "--out=" + folder.string(),
                                 fmt::format("--frames={0}-{0}", still.frame),
                                 fmt::format("--size={}x{}", still.size[0], still.size[1]),
                                 "--quality=" + still.quality,
                                 "-q"};
  for (const std::string& set : still.sets) words.push_back("--set=" + set);
  // Of a film eight frames more would be rendered. A still with a lens is resolved, in half of the time and
  // with less noise.
  if (Result<Preset> preset = preset_of(still);
      preset && !preset->film.air && (preset->film.frames > 1 || !preset->setup.camera.aperture))
    words.emplace_back("--no-resolve");
  return call_for(root, words);
}

Result<Rendered> render_still(const fs::path& root, const Still& still, const fs::path& folder) {
  if (Errors errors = write_scene(root, still, folder); !errors.empty()) return errors;
  // Before it is rendered: what is a frame's own may go then.
  Result<std::string> id = scene_id(root, folder / "frames", scenes_of(folder, still.frame));
  if (!id) return id.errors();
  std::string picture = "frames/" + frame_name(still.frame) + ".png";
  if (Errors errors = call_for(root, {"ninja", picture}, folder); !errors.empty()) return errors;
  return Rendered{folder / picture, std::move(*id)};
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
    Result<Preset> preset = preset_of(still);
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
