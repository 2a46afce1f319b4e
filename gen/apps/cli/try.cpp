#include <filesystem>

#include "cli/browser.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/streams.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The page as it is installed or, in a checkout, as it was built; empty where it is neither.
fs::path page_below(const fs::path& root) {
  std::error_code error;
  for (const char* folder : {"try", "build/try/page"})
    if (fs::path page = root / folder / "index.html"; fs::exists(page, error))
      return fs::weakly_canonical(page, error);
  return {};
}

void open_page(bool only_print) {
  fs::path root = or_fail(home(), kCouldNot);
  fs::path page = page_below(root);
  if (page.empty())
    fail({Error{"try", "the page was not built; in a checkout of Frond scripts/setup.sh --try does it"}},
         kWrongInput);
  put(page.string() + "\n");
  flush();
  if (only_print || open_in_browser(page)) return;
  fail({Error{"xdg-open", "there is none; open the file by hand"}}, kCouldNot);
}

}  // namespace

void add_try(CLI::App& app) {
  auto [command, only_print] =
      add_command(app, "try", "Opens a page in the browser to try grammars, trees and corals on", open_page);
  command->add_flag("--print", *only_print, "Opens nothing, and prints where the page is");
  command->footer(R"(Example:
  frond try)");
}

}  // namespace frond
