#include "studio/studio.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "cli/browser.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/home.h"
#include "core/work_folder.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A page that leads to an address, in a file that its owner alone can read: a program's arguments everybody
/// can. It goes with this.
class Doorway {
 public:
  explicit Doorway(const std::string& address) {
    constexpr const char* kPage =
        "<!doctype html>\n<meta charset=\"utf-8\">\n<meta name=\"referrer\" content=\"no-referrer\">\n"
        "<title>Frond</title>\n<script>location.replace(\"{0}\")</script>\n<a href=\"{0}\">Frond</a>\n";
    std::error_code error;
    there_ = !folder_.path().empty() && write_file(page(), fmt::format(kPage, address));
    if (there_) fs::permissions(page(), fs::perms::owner_read | fs::perms::owner_write, error);
  }

  bool there() const { return there_; }
  fs::path page() const { return folder_.path() / "studio.html"; }

 private:
  WorkFolder folder_;
  bool there_ = false;
};

/// Where there is no desktop the printed address does.
void open_by(const Doorway& doorway) {
  if (!doorway.there()) return tell("note: no file could be made to open; open the address by hand");
  if (!open_in_browser(doorway.page())) tell("note: there is no xdg-open; open the address by hand");
}

}  // namespace

void studio(const StudioArguments& arguments) {
  StudioOptions options;
  options.home = or_fail(home(), kCouldNot);
  options.port = arguments.port;
  options.memory = arguments.memory << 20;
  options.bake = {.home = options.home, .cache = cache_folder() / "materials"};
  if (arguments.assets) options.assets = *arguments.assets;
  if (!arguments.preset.empty()) {
    // A file that is not there is told here; faults in it are the page's to show.
    if (!is_file(arguments.preset))
      fail({Error{arguments.preset, "is no file" + nearest_presets(arguments.preset)}}, kWrongInput);
    options.preset = arguments.preset;
  }
  std::optional<Doorway> doorway;
  options.ready = [&](const std::string& address) {
    put(address + "\n");
    flush();
    tell("Open this address in a browser; Ctrl+C ends the studio.");
    if (!arguments.open) return;
    doorway.emplace(address);
    open_by(*doorway);
  };
  now_doing("serving the studio");
  or_fail(serve_studio(options), kCouldNot);
}

}  // namespace frond
