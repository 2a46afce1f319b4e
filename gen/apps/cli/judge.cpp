#include "cli/judge.h"

#include <fmt/format.h>

#include <string_view>

#include "cli/inputs.h"
#include "jobs/jobs.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Two options of a command that do not go together, and why.
struct Unfit {
  std::string_view command, one, other;  ///< "*": any other
  std::string_view why;
};

constexpr std::string_view kSheet = "a sheet is of stills; expected one of the two";
constexpr std::string_view kWhy = "nothing is rendered; expected --why alone";
constexpr std::string_view kOneOf = "expected one of the two";
constexpr std::string_view kOnlyLooks = "this only looks at what was handed over; expected it alone";

constexpr Unfit kUnfit[] = {
    {"render", "--compare", "*", "nothing is rendered; expected --compare alone"},
    {"render", "--why", "--format", kWhy},
    {"render", "--why", "--every", kWhy},
    {"render", "--why", "--watch", kWhy},
    {"render", "--why", "--plot", kWhy},
    {"render", "--why", "--jobs", kWhy},
    {"render", "--why", "--sweep", kWhy},
    {"render", "--why", "--contact-seeds", kWhy},
    {"render", "--sweep", "--format", kSheet},
    {"render", "--sweep", "--every", kSheet},
    {"render", "--sweep", "--watch", kSheet},
    {"render", "--sweep", "--plot", kSheet},
    {"render", "--contact-seeds", "--format", kSheet},
    {"render", "--contact-seeds", "--every", kSheet},
    {"render", "--contact-seeds", "--watch", kSheet},
    {"render", "--contact-seeds", "--plot", kSheet},
    {"render", "--resolve", "--no-resolve", kOneOf},
    {"generate", "--resolve", "--no-resolve", kOneOf},
    {"farm", "--resolve", "--no-resolve", kOneOf},
    {"farm", "--status", "--cancel", kOnlyLooks},
    {"farm", "--status", "--logs", kOnlyLooks},
    {"farm", "--cancel", "--logs", kOnlyLooks},
    {"farm", "--hosts", "--openjd", kOneOf},
    {"farm", "--hosts", "--opencue", kOneOf},
    {"farm", "--hosts", "--partition", "a partition is one of Slurm; expected one of the two"},
    {"farm", "--partition", "--openjd", "a partition is one of Slurm; expected one of the two"},
    {"farm", "--partition", "--opencue", "a partition is one of Slurm; expected one of the two"},
    {"derive", "--tree", "--format", "a tree is a picture of the derivation; expected one of the two"},
    {"export", "--frame", "--frames", "the last of --frames is what --frame says; expected one of the two"},
    {"export", "--frames", "--lods", "only one mesh can move; expected one of the two"},
    {"export", "--frames", "--instances",
     "what moves is one mesh for each organism; expected one of the two"},
    {"export", "--lods", "--instances",
     "a level of detail is one mesh for each organism; expected one of the two"},
    {"film", "--columns", "--fps", "a sheet is a picture; expected one of the two"},
    {"film", "--columns", "--title", "a sheet is a picture; expected one of the two"},
    {"film", "--columns", "--comment", "a sheet is a picture; expected one of the two"},
    {"film", "--columns", "--alpha", "a sheet is a picture; expected one of the two"},
    {"film", "--columns", "--dpi", "only a copy of one picture says that; expected one of the two"},
};

/// An option that does nothing without another.
struct Needs {
  std::string_view command, one, other, why;
};

constexpr Needs kNeeds[] = {
    {"export", "--keys", "--frames", "it is about an animation; expected --frames, too"},
    {"film", "--width", "--columns", "it is about a sheet; expected --columns, too"},
};

bool given(const CLI::App& command, std::string_view name) {
  const CLI::Option* option = command.get_option_no_throw(std::string(name));
  return option && option->count() > 0;
}

/// The first option that is given besides one; empty if none is.
std::string another(const CLI::App& command, std::string_view one) {
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && !option->get_lnames().empty() && "--" + option->get_lnames()[0] != one)
      return "--" + option->get_lnames()[0];
  return {};
}

void judge_command(const CLI::App& command) {
  for (const Unfit& pair : kUnfit) {
    if (command.get_name() != pair.command || !given(command, pair.one)) continue;
    std::string other(pair.other);
    if (pair.other == "*") other = another(command, pair.one);
    if (!other.empty() && given(command, other))
      throw CLI::ValidationError(fmt::format("{} does not go with {}: {}", pair.one, other, pair.why));
  }
  for (const Needs& pair : kNeeds)
    if (command.get_name() == pair.command && given(command, pair.one) && !given(command, pair.other))
      throw CLI::ValidationError(
          fmt::format("{} does nothing without {}: {}", pair.one, pair.other, pair.why));
}

}  // namespace

void judge_options(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({}))
    command->parse_complete_callback([command] { judge_command(*command); });
}

Errors judge_render(const RenderArguments& a, const Film& film) {
  if (Errors errors = refuse_resolving(film, a.resolve); !errors.empty()) return errors;
  Result<FrameRange> range = read_frames(a.frames, film.frames, {1, film.frames});
  if (!range) return range.errors();
  if (a.why > 0 && (a.why < range->first || a.why > range->last))
    return {{"--why", fmt::format("{} is no frame of this {}; expected {}-{}", a.why,
                                  a.frames ? "run" : "film", range->first, range->last)}};
  if (film.transparent() && a.format == "mp4")
    return {{"--format", "an mp4 has no opacity; expected mov, webm, webp or gif"}};
  if (!film.transparent() && a.format == "mov")
    return {{"--format", "a mov is for a transparent film; expected mp4, webm, webp or gif"}};
  return {};
}

}  // namespace frond
