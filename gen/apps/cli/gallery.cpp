#include "gallery/gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"

// The pictures of docs/gallery, made from the presets as they are: gallery.

namespace frond {

namespace fs = std::filesystem;

void gallery(const GalleryArguments& arguments) {
  fs::path root = or_fail_run(home(), kCouldNot);
  std::error_code error;
  fs::path from_root = fs::absolute(root, error).lexically_normal();
  std::string text = or_fail_run(read_file(from_root / "docs" / "gallery" / "pictures.txt"), kCouldNot);
  GalleryList list = or_fail_run(read_gallery(text, "docs/gallery/pictures.txt"), kCouldNot);
  std::vector<std::string> names = arguments.names;
  if (arguments.large && names.empty()) names = list.large;
  if (arguments.large)
    for (std::string& name : names) name.insert(0, name.starts_with(kLargePrefix) ? "" : kLargePrefix);
  fs::path work = fs::absolute(arguments.out, error).lexically_normal();
  GalleryOrder order{from_root, work, std::move(list), std::move(names)};
  if (std::string wrong = wrong_name(order); !wrong.empty()) fail_run({{"", wrong}}, kWrongInput);
  fs::create_directories(work, error);
  if (error) fail_run({{"", work.string() + ": the folder cannot be made"}}, kCouldNot);
  auto name_one = [](const std::string& name) {
    put(name + "\n");
    flush();
  };
  auto tell_one = [&](const std::string& name, std::string_view why) {
    tell(fmt::format("{}: {}", name, why));
    name_one(name);
  };
  or_fail_run(arguments.stale ? find_stale(order, tell_one) : render_gallery(order, name_one), kCouldNot);
  if (!arguments.stale || !order.names.empty()) return;
  if (std::vector<std::string> others = others_in_gallery(order); !others.empty())
    tell(fmt::format("note: pictures that are made elsewhere, whose age is not known: {}",
                     fmt::join(others, " ")));
}

}  // namespace frond
