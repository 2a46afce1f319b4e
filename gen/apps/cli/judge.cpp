#include <fmt/format.h>

#include <string_view>

#include "cli/words.h"
#include "core/text.h"

// Options that do not go with each other: judged before anything is grown or rendered.

namespace frond {

namespace {

/// An option of a command that does not go with some others, and why.
struct Unfit {
  std::string_view command, one, others;  ///< with blanks between them; "*": any other
  std::string_view why;
};

constexpr std::string_view kOfFilms = "--format --every --watch --plot";
constexpr std::string_view kSheet = "a sheet is of stills; expected one of the two";
constexpr std::string_view kOneOf = "expected one of the two";
constexpr std::string_view kOnlyLooks = "this only looks at what was handed over; expected it alone";
constexpr std::string_view kPartition = "a partition is one of Slurm; expected one of the two";

constexpr Unfit kUnfit[] = {
    {"render", "--compare", "*", "nothing is rendered; expected --compare alone"},
    {"render", "--why", "--format --every --watch --plot --jobs --sweep --contact-seeds",
     "nothing is rendered; expected --why alone"},
    {"render", "--sweep", kOfFilms, kSheet},
    {"render", "--contact-seeds", kOfFilms, kSheet},
    {"render", "--resolve", "--no-resolve", kOneOf},
    {"generate", "--resolve", "--no-resolve", kOneOf},
    {"farm", "--resolve", "--no-resolve", kOneOf},
    {"farm", "--status", "--cancel --logs", kOnlyLooks},
    {"farm", "--cancel", "--logs", kOnlyLooks},
    {"farm", "--hosts", "--openjd --opencue", kOneOf},
    {"farm", "--hosts", "--partition", kPartition},
    {"farm", "--partition", "--openjd --opencue", kPartition},
    {"derive", "--tree", "--format", "a tree is a picture of the derivation; expected one of the two"},
    {"export", "--frame", "--frames", "the last of --frames is what --frame says; expected one of the two"},
    {"export", "--frames", "--lods", "only one mesh can move; expected one of the two"},
    {"export", "--frames", "--instances",
     "what moves is one mesh for each organism; expected one of the two"},
    {"export", "--lods", "--instances",
     "a level of detail is one mesh for each organism; expected one of the two"},
    {"film", "--columns", "--fps --title --comment --alpha", "a sheet is a picture; expected one of the two"},
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
  for (const Unfit& unfit : kUnfit) {
    if (command.get_name() != unfit.command || !given(command, unfit.one)) continue;
    for (std::string other : split(unfit.others, ' ')) {
      if (other == "*") other = another(command, unfit.one);
      if (!other.empty() && given(command, other))
        throw CLI::ValidationError(fmt::format("{} does not go with {}: {}", unfit.one, other, unfit.why));
    }
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

}  // namespace frond
