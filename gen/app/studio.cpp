#include "studio/studio.h"

#include <spawn.h>

#include <filesystem>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/streams.h"

extern char** environ;

namespace frond {

namespace {

/// Asks the desktop to open an address; where there is none the printed address does.
void open_in_browser(const std::string& address) {
  std::string program = "xdg-open", word = address;
  char* words[] = {program.data(), word.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ) != 0)
    tell("note: there is no xdg-open; open the address by hand");
}

}  // namespace

int studio(const StudioArguments& arguments) {
  Result<std::filesystem::path> root = home();
  if (!root) return fail(root.errors(), kCouldNot);
  StudioOptions options{
      .home = *root, .preset = {}, .port = arguments.port, .memory = {}, .assets = {}, .ready = {}};
  if (!arguments.preset.empty()) {
    // A file that is not there is told here; faults in it are the page's to show.
    std::error_code error;
    if (!std::filesystem::is_regular_file(arguments.preset, error))
      return fail({Error{arguments.preset, "is no file" + nearest_presets(arguments.preset)}}, kWrongInput);
    options.preset = arguments.preset;
  }
  options.memory = arguments.memory << 20;
  if (arguments.assets) options.assets = *arguments.assets;
  options.ready = [&](const std::string& address) {
    put(address + "\n");
    flush();
    tell("Open this address in a browser; Ctrl+C ends the studio.");
    if (arguments.open) open_in_browser(address);
  };
  now_doing("serving the studio");
  Errors errors = serve_studio(options);
  return errors.empty() ? kDone : fail(errors, kCouldNot);
}

}  // namespace frond
