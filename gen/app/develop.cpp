#include "app/commands.h"
#include "app/messages.h"
#include "core/files.h"

// The tone of a picture that POV-Ray has drawn: develop.

namespace frond {

int develop_picture(const DevelopArguments& arguments) {
  Result<std::string> drawn = read_file(arguments.picture);
  if (!drawn) return fail(drawn.errors(), kCouldNot);
  Result<std::string> picture = develop(*drawn, arguments.tone);
  if (!picture) return fail({Error{arguments.picture, picture.errors()[0].what}}, kCouldNot);
  Result<bool> written = write_file(arguments.out, *picture);
  return written ? kDone : fail(written.errors(), kCouldNot);
}

}  // namespace frond
