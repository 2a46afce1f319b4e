#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/messages.h"
#include "core/files.h"

// The tone of a picture that POV-Ray has drawn: develop.

namespace frond {

void develop_picture(const DevelopArguments& arguments) {
  std::vector<std::string> drawn;
  for (const std::string& path : arguments.pictures) drawn.push_back(or_fail(read_file(path), kCouldNot));
  Result<std::string> picture = develop(drawn, arguments.tone, arguments.depth);
  if (!picture)
    fail({Error{fmt::format("{}", fmt::join(arguments.pictures, ", ")), picture.errors()[0].what}},
         kCouldNot);
  or_fail(write_file(arguments.out, *picture), kCouldNot);
}

}  // namespace frond
