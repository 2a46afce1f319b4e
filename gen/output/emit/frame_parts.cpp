#include "emit/frame_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "core/content.h"
#include "core/parallel.h"
#include "core/text.h"
#include "draw/eyes.h"
#include "emit/branch_materials.h"
#include "emit/copies.h"
#include "emit/plant.h"
#include "emit/setting.h"
#include "emit/snow.h"

namespace frond {

namespace {

constexpr std::size_t kAside = 4'000'000;  // bytes that are not worth a file

/// Whether neighbours take light from it.
bool is_shaded(const Specimen& b) {
  return !b.model.light.empty() ||
         std::ranges::any_of(b.model.solids.shapes, [](const Solid& s) { return !s.light.empty(); });
}

/// Puts what is the same in all frames of a film into a file that they include, named by what is in it.
void put_aside(std::string& text, std::vector<Picture>& files) {
  if (text.size() < kAside) return;
  std::string name = fmt::format("part_{}.inc", content_id(text));
  files.push_back({name, std::move(text)});
  text = "#include \"" + name + "\"\n";
}

}  // namespace

FrameParts prepare_frames(const Scene& scene, CopyPlan plan, bool for_film) {
  float thinnest = std::numeric_limits<float>::infinity();
  for (const Specimen& b : scene.specimens)
    for (float radius : b.model.skeleton.radius) thinnest = std::min(thinnest, radius);
  FrameParts parts;
  parts.space = space_for(thinnest);
  parts.pixel = for_film ? nearest_pixels(scene) : std::vector<double>(scene.specimens.size(), 0);
  std::size_t skins = 0;
  for (const Specimen& b : scene.specimens) {
    parts.first_skin.push_back(skins);
    skins += b.look.branches.drawn() ? b.look.branches.colors() : 0;
  }
  std::string count = number_text(static_cast<double>(std::max<std::size_t>(1, skins)));
  parts.materials =
      "#declare Skin = array[" + count + "];\n#declare Skin_Pigment = array[" + count + "][2];\n";
  if (std::ranges::any_of(scene.specimens, is_shaded)) append_bleaching(parts.materials);
  if (std::ranges::any_of(scene.specimens, [](const Specimen& b) { return !b.model.light.empty(); }))
    parts.materials +=
        "#declare Skin_Bleached = array[" + count + "];\n#declare Skin_Dead = array[" + count + "];\n";
  append_skins(parts.materials, scene, parts.first_skin);
  parts.materials +=
      prototypes_text(parts.space, scene, parts.pixel) + bough_snow_declarations(parts.space, scene);
  if (for_film) parts.solids = drawn_solids(scene);
  parts.polyps.resize(scene.specimens.size());
  parallel_for(parts.polyps.size(),
               [&](std::size_t i) { parts.polyps[i] = polyp_places(parts.solids.of(scene, i)); });
  parts.ground = ground_text(parts.space, scene) + solids_text(parts.space, scene, parts.solids).text;
  parts.copies.resize(plan.drawn.size());
  parallel_for(parts.copies.size(), [&](std::size_t k) {
    parts.copies[k] =
        model_includes_text(scene, plan, k) + still_copies_text(parts.space, scene, plan, k).text;
  });
  parts.plan = std::move(plan);
  if (for_film && scene.film.frames > 1) {
    put_aside(parts.materials, parts.files);
    put_aside(parts.ground, parts.files);
    for (std::string& some : parts.copies) put_aside(some, parts.files);
  }
  return parts;
}

}  // namespace frond
