#include "cli/words.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/inputs.h"
#include "core/files.h"
#include "core/text.h"

namespace frond {

namespace {

std::string with_nearest(std::string text, std::string_view word, const std::vector<std::string>& names) {
  std::string_view near = nearest_name(word, names);
  return near.empty() ? text : fmt::format("{}; did you mean \"{}\"?", text, near);
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

struct CommandGroup {
  std::string heading;
  std::vector<std::string> commands;
};

const std::vector<CommandGroup>& command_groups() {
  static const std::vector<CommandGroup> groups{
      {"Make", {"new", "describe", "list", "schema", "check", "import", "studio", "try"}},
      {"Look", {"look", "info", "draw", "plan", "stand", "derive", "turtle"}},
      {"Render", {"render", "sheet", "generate", "resolve", "film", "compare"}},
      {"Give to other programs", {"export", "passes", "textures"}},
      {"Render on many machines", {"farm"}},
      {"For scripts", {"files", "completion", "man"}},
  };
  return groups;
}

}  // namespace

void group_commands(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) command->group("");
  for (const CommandGroup& group : command_groups())
    for (const std::string& name : group.commands) app.get_subcommand(name)->group(group.heading);
}

std::vector<std::string> words_of(int count, char** words) {
  constexpr std::string_view kOptions = "-ohq";  // first letters, and that of long ones
  std::vector<std::string> list(words, words + count);
  for (std::string& word : list) {
    if (word == "--") break;
    bool option = word.size() < 2 || word[0] != '-' || kOptions.find(word[1]) != kOptions.npos;
    if (!option && is_file(word)) word.insert(0, "./");
  }
  return list;
}

std::string unknown_command(const CLI::App& app, std::string_view word) {
  std::vector<std::string> names = commands_of(app);
  if (word.empty() || word.starts_with('-') || std::ranges::find(names, word) != names.end()) return {};
  return with_nearest(fmt::format("{}: no such command; expected one of {}", word, fmt::join(names, ", ")),
                      word, names);
}

std::string unknown_option(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> commands = commands_of(app);
  bool named = words.size() > 1 && std::ranges::find(commands, words[1]) != commands.end();
  const CLI::App* command = named ? app.get_subcommand(words[1]) : &app;
  std::vector<std::string> names;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const std::string& word : words) {
    if (word == "--") break;
    std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::ranges::find(names, name) != names.end()) continue;
    return with_nearest(fmt::format("{}: no such option of frond{}", name, named ? " " + words[1] : ""), name,
                        names);
  }
  return {};
}

std::string first_words(const std::string& program) {
  std::string text =
      "Frond grows plants and corals from JSON presets and writes scenes that POV-Ray films.\n\n";
  auto row = [&](const std::string& call, const char* does) {
    text += fmt::format("  {:38} {}\n", call, does);
  };
  row(program + " new my_tree --from tree", "writes a commented preset to begin with");
  if (std::string render = render_command(); !render.empty())
    row(render + " my_tree.json", "makes a picture or a film of it");
  row(program + " studio my_tree.json --open", "sliders and a live view in the browser");
  row(program + " describe tree", "says what each property does");
  row(program + " check my_tree.json", "says what is wrong in it");
  row(program + " list", "presets, kinds, settings and turtle symbols");
  return text +
         fmt::format("\n{0} --help lists all commands, {0} COMMAND --help the options of one; ", program) +
         "docs/start.md takes ten minutes.\n";
}

}  // namespace frond
