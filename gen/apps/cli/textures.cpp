#include <fmt/format.h>

#include "appearance/bark_coat.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/printable.h"
#include "images/bark.h"
#include "images/leaf.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Writes pictures under names of their own and says so.
class Album {
 public:
  Album(fs::path folder, bool quiet) : folder_(std::move(folder)), quiet_(quiet) {}

  void add(const std::string& name, const Raster& raster) {
    Result<std::string> bytes = png_text(raster);
    if (!bytes) return add_errors(bytes.errors());
    Result<bool> written = write_file(folder_ / (name + ".png"), *bytes);
    if (!written) return add_errors(written.errors());
    if (!quiet_) put((folder_ / (name + ".png")).string() + "\n");
  }

  void bark(const std::string& name, const BarkCoat& coat) {
    int height = std::max(1, static_cast<int>(coat.pixels * coat.aspect + 0.5));
    Seed seed{11};
    BarkMaps maps = bark_maps(coat.image, coat.pixels, height, seed);
    Raster colors = bark_colors(coat.image, maps, seed),
           normals = normal_picture(maps.height, coat.pixels / 9.0);
    add(name + "_bark_height", grey_picture(maps.height));
    add(name + "_bark_normal", normals);
    add(name + "_bark_color", colors);
    add(name + "_bark_lit", lit_picture(colors, normals));
  }

  /// A leaf alone, and its sprig with an end leaf and without.
  void leaves(const std::string& name, const LeafLook& look) {
    LeafImage leaf = leaf_image(look, 0);
    for (const char* what : {"leaf", "sprig", "sprig_even"}) {
      leaf.sprig = what != std::string_view("leaf");
      leaf.sprigs.end_leaf = what == std::string_view("sprig");
      add(name + "_" + what, leaf_picture(leaf, look.pixels, Seed{0}));
    }
  }

  const Errors& errors() const { return errors_; }

 private:
  void add_errors(const Errors& errors) { errors_.insert(errors_.end(), errors.begin(), errors.end()); }

  fs::path folder_;
  bool quiet_;
  Errors errors_;
};

}  // namespace

void write_textures(const TextureArguments& arguments) {
  limit_threads(arguments.threads);
  now_doing("drawing bark and leaves");
  Album album(arguments.out.empty() ? "out/textures" : arguments.out, arguments.quiet);
  if (arguments.preset.path.empty()) {
    // All that there is.
    constexpr std::pair<const char*, BarkPattern> kBarks[] = {{"furrowed", BarkPattern::furrowed},
                                                              {"plated", BarkPattern::plated},
                                                              {"smooth", BarkPattern::smooth},
                                                              {"banded", BarkPattern::banded}};
    for (auto [name, pattern] : kBarks) {
      BarkCoat coat;
      coat.image.pattern = pattern;
      if (pattern == BarkPattern::banded) coat.image.color = {0.90f, 0.88f, 0.84f};
      if (pattern == BarkPattern::smooth) coat.image.color = {0.55f, 0.54f, 0.48f};
      album.bark(name, coat);
    }
    for (std::size_t i = 0; i < leaf_names().size(); ++i) {
      LeafLook look;
      look.shape = static_cast<LeafShape>(i);
      look.pixels = 512;
      album.leaves(std::string(leaf_names()[i]), look);
    }
    return or_fail(album.errors(), kCouldNot);
  }
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  tell_notes(preset.notes);
  bool any = false;
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    Look look = preset.organisms[i].grower->appearance().look;
    if (!look.leaves && !look.branches.coat) continue;
    any = true;
    const std::string& own = preset.organisms[i].name;
    bool fit =
        !own.empty() && own.size() <= kLongestName && own.find('/') == own.npos && printable(own) == own;
    std::string name = fit ? own : fmt::format("organism_{}", i);
    if (look.branches.coat) album.bark(name, *look.branches.coat);
    if (look.leaves) album.leaves(name, *look.leaves);
  }
  if (!any)
    fail({{arguments.preset.path,
           "has no trees with pictures; expected the kind weber_penn or colonized, or "
           "tree with a coat or leaves.picture"}},
         kWrongInput);
  or_fail(album.errors(), kCouldNot);
}

}  // namespace frond
