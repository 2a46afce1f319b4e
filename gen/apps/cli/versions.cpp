#include <fmt/format.h>

#include "cli/words.h"
#include "core/version.h"
#include "render/process.h"

namespace frond {

namespace {

/// What POV-Ray calls itself, and where it lies.
std::string renderer() {
  std::string name = environment_or("FROND_POVRAY", "povray");
  std::optional<std::filesystem::path> program = find_program(name);
  if (!program) return fmt::format("POV-Ray: none found as {}", name);
  OutputCapture words;
  Command command;
  command.words = {program->string(), "--version"};
  command.out = command.err = words.descriptor();
  Result<int> code = run(command);
  std::string own = "POV-Ray";
  if (code && *code == 0)
    for (const std::string& line : lines_of(words.text()))
      if (line.starts_with("POV-Ray ")) {
        own = line.substr(0, line.find_last_not_of(" \r") + 1);
        break;
      }
  return fmt::format("{} ({})", own, program->string());
}

}  // namespace

std::string versions() { return fmt::format("frond {}\n{}\n{}", version(), FROND_LIBRARIES, renderer()); }

}  // namespace frond
