#include "cli/command_groups.h"

#include <string>
#include <vector>

namespace frond {

namespace {

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

}  // namespace frond
