#include "cli/try.h"

#include <filesystem>
#include <memory>

#include "cli/browser.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
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

int open_page(bool only_print) {
  Result<fs::path> root = home();
  if (!root) return fail(root.errors(), kCouldNot);
  fs::path page = page_below(*root);
  if (page.empty())
    return fail(
        {Error{"try", "the page was not built; in a checkout of Frond scripts/setup.sh --try does it"}},
        kWrongInput);
  put(page.string() + "\n");
  flush();
  if (only_print || open_in_browser(page)) return kDone;
  return fail({Error{"xdg-open", "there is none; open the file by hand"}}, kCouldNot);
}

}  // namespace

void add_try(CLI::App& app, int& result) {
  auto only_print = std::make_shared<bool>(false);
  auto* command =
      app.add_subcommand("try", "Opens a page in the browser to try grammars, trees and corals on");
  command->add_flag("--print", *only_print, "Opens nothing, and prints where the page is");
  command->footer("Example:\n  frond try");
  command->callback([&result, only_print] { result = open_page(*only_print); });
}

}  // namespace frond
