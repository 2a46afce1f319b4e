#include "cli/browser.h"

#include <spawn.h>

#include <string>

extern char** environ;

namespace frond {

bool open_in_browser(const std::filesystem::path& page) {
  std::string program = "xdg-open", word = page.string();
  char* words[] = {program.data(), word.data(), nullptr};
  pid_t child = 0;
  return posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ) == 0;
}

}  // namespace frond
