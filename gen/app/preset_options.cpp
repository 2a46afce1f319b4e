#include <fmt/format.h>

#include "app/rendering.h"

namespace frond {

void add_assets(CLI::App* command, std::optional<std::string>& assets) {
  command->add_option("--assets", assets,
                      "DIR: reads no file but below the preset's own folder and this one");
}

void add_preset(CLI::App* command, PresetArguments& preset) {
  command->add_option("preset", preset.path, "The preset, a JSON file")->required();
  command->add_option("--set", preset.sets, "POINTER=VALUE: overrides one value, as in /film/fps=12")
      ->allow_extra_args(false);
  command->add_option("--size", preset.size, "WxH: size of the pictures, in pixels");
  command->add_option("--scale", preset.scale, "N: multiplies the size, by 1 to 16");
  command->add_option("--quality", preset.quality, "draft, good or best");
  add_assets(command, preset.assets);
}

void add_resolving(CLI::App* command, std::optional<bool>& resolve) {
  command->add_flag_callback(
      "--resolve", [&resolve] { resolve = true; },
      "POV-Ray draws one sample a pixel, and each frame is resolved with those around it, "
      "as in the quality good");
  command->add_flag_callback(
      "--no-resolve", [&resolve] { resolve = false; },
      "Each frame has all its samples, in the quality good, too");
}

std::string as_path(const std::string& path) { return path.starts_with('-') ? "./" + path : path; }

void add_words(std::vector<std::string>& words, const PresetArguments& preset) {
  words.push_back(as_path(preset.path));
  for (const std::string& set : preset.sets) words.push_back("--set=" + set);
  if (preset.size) words.push_back("--size=" + *preset.size);
  if (preset.scale) words.push_back(fmt::format("--scale={}", *preset.scale));
  if (preset.quality) words.push_back("--quality=" + *preset.quality);
  if (preset.assets) words.push_back("--assets=" + *preset.assets);
}

}  // namespace frond
