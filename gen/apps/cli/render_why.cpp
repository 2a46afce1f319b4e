#include "cli/render_why.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/printable.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The reason that ninja gives first; the others follow from it. Empty where there is none.
std::string reason_told(const std::string& told, const std::string& name) {
  auto says = [&](const std::string& words) { return told.find(words) != told.npos; };
  std::string scene = name + ".pov", picture = name + ".png", older = "older than most recent input ";
  if (says(scene) && says(" is missing"))
    return "its scene " + scene + " is missing; the next run writes it again";
  if (says(picture + " doesn't exist")) return "there is no picture of it";
  if (says(older + scene)) return "its scene is newer than its picture";
  if (says(older)) {
    std::string rest = told.substr(told.find(older) + older.size());
    return rest.substr(0, rest.find(" (")) + " is newer than its picture";
  }
  if (says("command line changed for " + picture))
    return "its size, quality or flags are others than those it was rendered with";
  if (says("command line not found in log")) return "nothing is noted of how its picture was rendered";
  return says("no work to do") ? "" : told;
}

/// The first line that differs in two texts, as it was and as it is.
void tell_change(const std::string& before, const std::string& now) {
  std::vector<std::string> was = lines_of(before), is = lines_of(now);
  was.resize(std::max(was.size(), is.size()));
  is.resize(was.size());
  auto [a, b] = std::ranges::mismatch(was, is);
  if (a == was.end()) return;
  constexpr std::size_t kMost = 100;
  put(fmt::format("its scene has changed, from line {} on:\n  was: {}\n  is:  {}\n", a - was.begin() + 1,
                  printable(a->substr(0, kMost)), printable(b->substr(0, kMost))));
}

}  // namespace

void tell_why(const Ninja& ninja, const fs::path& out, int frame, const std::string& before) {
  std::string name = "frames/" + frame_name(frame);
  std::string told = ninja.answer({"-d", "explain", "-n", name + ".png"});
  if (told.find("unknown target") != told.npos)
    fail_run({{"", fmt::format("frame {} is none of this film", frame)}}, kWrongInput);
  std::string reason = reason_told(told, name);
  if (reason.empty()) {
    put(fmt::format("frame {} is up to date\n", frame));
    return;
  }
  put(fmt::format("frame {} is rendered again: {}\n", frame, reason));
  if (Result<std::string> now = read_file(out / (name + ".pov")); now && !before.empty())
    tell_change(before, *now);
}

}  // namespace frond
