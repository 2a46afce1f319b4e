// The command line of Frond. Each command is one function in commands.h.

#include <CLI/CLI.hpp>

#include "app/commands.h"

using namespace frond;

namespace {

void add_preset(CLI::App* command, PresetArguments& preset) {
  command->add_option("preset", preset.path, "The preset, a JSON file")->required();
  command->add_option("--set", preset.sets, "POINTER=VALUE: overrides one value, as in /film/fps=12")
      ->allow_extra_args(false);
  command->add_option("--size", preset.size, "WxH: size of the pictures, in pixels");
  command->add_option("--quality", preset.quality, "draft, good or best");
}

void add_grammar(CLI::App* command, GrammarArguments& grammar) {
  command
      ->add_option(
          "grammar", grammar.path,
          "A grammar or a preset in JSON, or a grammar of cpfg (.l), LParser (.ls) or Houdini (.txt)")
      ->required();
  command->add_option("--steps", grammar.steps, "Derivation steps, instead of the grammar's")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--seed", grammar.seed, "For random choices, instead of the grammar's");
}

}  // namespace

int main(int count, char** words) {
  CLI::App app{"Grows plants and corals from JSON presets and writes scenes that POV-Ray films."};
  app.require_subcommand(1);
  app.set_version_flag("--version", FROND_VERSION);

  int result = kDone;

  GenerateArguments to_generate;
  auto* generate_command =
      app.add_subcommand("generate", "Writes the frames of a film, manifest.json and build.ninja");
  add_preset(generate_command, to_generate.preset);
  generate_command->add_option("-o,--out", to_generate.out, "Folder to write to (out/<preset name>)");
  generate_command->add_option("--frames", to_generate.frames, "A-B: only these frames");
  generate_command->add_option("--threads", to_generate.threads, "How many threads (all)")
      ->check(CLI::NonNegativeNumber);
  generate_command->add_flag("-q,--quiet", to_generate.quiet, "No progress");
  generate_command->footer(
      "Example:\n  frond generate presets/reef.json -o out/reef --frames 1-24 --set /seed=8");
  generate_command->callback([&] { result = generate(to_generate); });

  std::vector<std::string> to_check;
  auto* check_command = app.add_subcommand("check", "Tells what is wrong in presets");
  check_command->add_option("presets", to_check, "JSON files")->required();
  check_command->footer("Example:\n  frond check presets/*.json");
  check_command->callback([&] { result = check(to_check); });

  PresetArguments to_size;
  bool info_json = false;
  auto* info_command = app.add_subcommand("info", "Says how large a preset's scene is");
  add_preset(info_command, to_size);
  info_command->add_flag("--json", info_json, "For machines");
  info_command->footer("Example:\n  frond info presets/reef.json --json");
  info_command->callback([&] { result = info(to_size, info_json); });

  GrammarArguments to_derive, to_walk;
  std::string format = "text";
  auto* derive_command = app.add_subcommand("derive", "Derives the word of a grammar");
  add_grammar(derive_command, to_derive);
  derive_command->add_option("--format", format, "text or counts")->check(CLI::IsMember({"text", "counts"}));
  derive_command->add_option("--tree", to_derive.picture, "SVG file: which symbol came from which");
  derive_command->footer("Example:\n  frond derive koch.json --steps 2 --tree koch.svg");
  derive_command->callback([&] {
    to_derive.counts = format == "counts";
    result = derive_word(to_derive);
  });

  auto* turtle_command = app.add_subcommand("turtle", "Walks a grammar's word and measures the way, as JSON");
  add_grammar(turtle_command, to_walk);
  turtle_command->add_option("--svg", to_walk.picture,
                             "SVG file: what the turtle draws, seen from the front");
  turtle_command->footer("Example:\n  frond turtle koch.json --steps 3 --svg koch.svg");
  turtle_command->callback([&] { result = walk_turtle(to_walk); });

  auto* schema_command = app.add_subcommand("schema", "Prints the JSON Schema of presets");
  schema_command->callback([&] { result = print_schema(); });

  bool list_json = false;
  auto* list_command = app.add_subcommand("list", "Lists growers, settings, presets and turtle symbols");
  list_command->add_flag("--json", list_json, "For machines");
  list_command->callback([&] { result = list_everything(list_json); });

  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kWrongInput;
  }
  return result;
}
