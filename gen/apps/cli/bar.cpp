#include "cli/bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "cli/messages.h"
#include "cli/streams.h"
#include "render/process.h"

namespace frond {

namespace {

bool drawn = false;

}  // namespace

bool on_terminal() { return ::isatty(2) && environment_or("TERM", "dumb") != "dumb"; }

void draw_bar(int done, int all, std::string_view words) {
  constexpr int kWidth = 30;
  std::size_t filled = static_cast<std::size_t>(std::clamp(done * kWidth / std::max(all, 1), 0, kWidth));
  put_words(fmt::format("\r\x1b[K[{:{}}] {}", std::string(filled, '#'), kWidth, words));
  drawn = true;
}

void end_bar() {
  if (drawn) put_words("\r\x1b[K");
  drawn = false;
}

void say(std::string_view line) {
  end_bar();
  tell(line);
}

}  // namespace frond
