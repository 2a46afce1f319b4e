#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/messages.h"
#include "core/files.h"

// The tone of a picture that POV-Ray has drawn: develop.

namespace frond {

int develop_picture(const DevelopArguments& arguments) {
  std::vector<std::string> drawn;
  for (const std::string& path : arguments.pictures) {
    Result<std::string> read = read_file(path);
    if (!read) return fail(read.errors(), kCouldNot);
    drawn.push_back(std::move(*read));
  }
  Result<std::string> picture = develop(drawn, arguments.tone, arguments.depth);
  if (!picture)
    return fail({Error{fmt::format("{}", fmt::join(arguments.pictures, ", ")), picture.errors()[0].what}},
                kCouldNot);
  Result<bool> written = write_file(arguments.out, *picture);
  return written ? kDone : fail(written.errors(), kCouldNot);
}

}  // namespace frond
