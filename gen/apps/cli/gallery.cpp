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

int gallery(const GalleryArguments& arguments) {
  Result<fs::path> root = home();
  if (!root) return fail_run(root.errors(), kCouldNot);
  std::error_code error;
  fs::path from_root = fs::absolute(*root, error).lexically_normal();
  Result<std::string> text = read_file(from_root / "docs" / "gallery" / "pictures.txt");
  Result<GalleryList> list = text ? read_gallery(*text, "docs/gallery/pictures.txt") : text.errors();
  if (!list) return fail_run(list.errors(), kCouldNot);
  std::vector<std::string> names = arguments.names;
  if (arguments.large && names.empty()) names = list->large;
  if (arguments.large)
    for (std::string& name : names) name.insert(0, name.starts_with(kLargePrefix) ? "" : kLargePrefix);
  fs::path work = fs::absolute(arguments.out, error).lexically_normal();
  GalleryOrder order{from_root, work, std::move(*list), std::move(names)};
  if (std::string wrong = wrong_name(order); !wrong.empty()) return fail_run({{"", wrong}}, kWrongInput);
  fs::create_directories(work, error);
  if (error) return fail_run({{"", work.string() + ": the folder cannot be made"}}, kCouldNot);
  auto name_one = [](const std::string& name) {
    put(name + "\n");
    flush();
  };
  auto tell_one = [&](const std::string& name, std::string_view why) {
    tell(fmt::format("{}: {}", name, why));
    name_one(name);
  };
  Errors errors = arguments.stale ? find_stale(order, tell_one) : render_gallery(order, name_one);
  if (!errors.empty()) return fail_run(errors, kCouldNot);
  if (!arguments.stale || !order.names.empty()) return kDone;
  if (std::vector<std::string> others = others_in_gallery(order); !others.empty())
    tell(fmt::format("note: pictures that are made elsewhere, whose age is not known: {}",
                     fmt::join(others, " ")));
  return kDone;
}

}  // namespace frond
