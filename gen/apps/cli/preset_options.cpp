#include <fmt/format.h>

#include "cli/named.h"
#include "cli/rendering.h"

namespace frond {

CLI::Validator named_by(std::string (*find)(const std::string&)) {
  return CLI::Validator(
      [find](std::string& word) {
        word = find(word);
        return std::string();
      },
      "", "a file");
}

void add_sets(CLI::App* command, std::vector<std::string>& sets) {
  command->add_option("--set", sets, "POINTER=VALUE: overrides one value, as in /film/fps=12")
      ->allow_extra_args(false);
}

void add_assets(CLI::App* command, std::optional<std::string>& assets) {
  command->add_option("--assets", assets,
                      "DIR: reads no file but below the preset's own folder and this one");
}

void add_preset(CLI::App* command, PresetArguments& preset) {
  command->add_option("preset", preset.path, "The preset, a JSON file, or the name of one of Frond's, as oak")
      ->required()
      ->transform(named_by(&preset_named));
  add_sets(command, preset.sets);
  add_assets(command, preset.assets);
}

void add_size(CLI::App* command, PresetArguments& preset) {
  command->add_option("--size", preset.size, "WxH: size of the pictures, in pixels");
  command->add_option("--scale", preset.scale, "N: multiplies the size, by 1 to 16");
  command->add_option("--quality", preset.quality, "draft, good or best");
  command->add_option("--fps", preset.fps, "N: frames a second");
  command->add_option("--seconds", preset.seconds, "S: how long the film is, at its frames a second");
}

void add_print(CLI::App* command, PresetArguments& preset) {
  command->add_option("--print", preset.print,
                      "20cm, 20x15cm, 150mm, 8in: size on paper, of the long side or of both");
  command->add_option("--dpi", preset.dpi, "N: pixels an inch of --print (300), which a still says");
  command->add_flag("--transparent", preset.transparent,
                    "Only what grows and stands there, on a transparent background");
}

void add_pictures(CLI::App* command, PresetArguments& preset) {
  add_size(command, preset);
  add_print(command, preset);
  command->add_option("--crop", preset.crop,
                      "X,Y,WxH: draws only this part, in pixels or per cent, as in 10%,20%,50%x50%");
  command->add_option("--depth", preset.depth, "8 or 16 bits a channel (8)")->check(CLI::IsMember({8, 16}));
}

void add_mutations(CLI::App* command, int& mutations) {
  command->add_option("--mutate", mutations, "N: how often rules of LParser are changed by chance")
      ->check(CLI::Range(0, 10'000));
}

void add_system(CLI::App* command, std::string& system) {
  command->add_option("--system", system, "NAME: which L-system of a file of Fractint that holds several");
}

CLI::Option* add_grammar(CLI::App* command, GrammarArguments& grammar) {
  command
      ->add_option(
          "grammar", grammar.path,
          "A grammar or a preset in JSON, or a grammar of cpfg (.l), LParser (.ls) or Houdini (.txt)")
      ->required()
      ->transform(named_by(&grammar_named));
  command->add_option("--seed", grammar.seed, "For random choices, instead of the grammar's");
  command->add_option("--angle", grammar.angle, "Degrees of turns that give none, instead of the grammar's")
      ->check(CLI::Range(-360.0, 360.0));
  add_mutations(command, grammar.mutations);
  add_system(command, grammar.system);
  add_assets(command, grammar.assets);
  return command->add_option("--steps", grammar.steps, "Derivation steps, instead of the grammar's")
      ->check(CLI::Range(0.0, 1e6));
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
  if (preset.fps) words.push_back(fmt::format("--fps={}", *preset.fps));
  if (preset.seconds) words.push_back(fmt::format("--seconds={}", *preset.seconds));
  if (preset.print) words.push_back("--print=" + *preset.print);
  if (preset.dpi) words.push_back(fmt::format("--dpi={}", *preset.dpi));
  if (preset.crop) words.push_back("--crop=" + *preset.crop);
  if (preset.depth) words.push_back(fmt::format("--depth={}", *preset.depth));
  if (preset.transparent) words.emplace_back("--transparent");
  if (preset.assets) words.push_back("--assets=" + *preset.assets);
}

}  // namespace frond
