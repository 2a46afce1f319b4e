#include "render/confine.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "cli/commands.h"
#include "cli/messages.h"

// A program that may open nothing but what it is given: confine.

namespace frond {

void run_confined(const ConfineArguments& arguments) {
  if (!can_confine()) fail({no_landlock()}, kNoLandlock);
  Confinement to{{arguments.read.begin(), arguments.read.end()},
                 {arguments.write.begin(), arguments.write.end()}};
  std::vector<char*> words;
  for (const std::string& word : arguments.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  or_fail(confine(to, words[0]), kCouldNot);
  ::execvp(words[0], words.data());
  fail({Error{words[0], std::strerror(errno)}}, kCouldNot);
}

}  // namespace frond
