#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "appearance/bleaching.h"
#include "core/content.h"
#include "core/parallel.h"
#include "draw/eyes.h"
#include "emit/branch_materials.h"
#include "emit/copies.h"
#include "emit/frame.h"
#include "emit/plant.h"
#include "emit/setting.h"
#include "emit/twigs.h"
#include "emit/weather.h"

namespace frond {

namespace {

constexpr std::size_t kAside = 4'000'000;  // bytes that are not worth a file

/// Whether neighbours take light from it.
bool is_shaded(const Specimen& b) {
  return !b.model.light.empty() ||
         std::ranges::any_of(b.model.solids.shapes, [](const Solid& s) { return !s.light.empty(); });
}

/// Declares `Bleaching`, by which macros know what becomes of living skin in the shade.
void append_bleaching(std::string& text) {
  const Bleaching& b = kBleaching;
  text += "#declare Bleaching = array[5]{";
  append_vector(text, 5, b.dead_light, b.pale_light, b.living_light);
  for (Vec3 light : {b.lime, b.turf}) text += ',', append_light(text, light);
  text += ',';
  append_vector(text, 5, b.kept, b.lime_least, b.lime_by_gray);
  text += ',';
  append_vector(text, 5, b.turf_least, b.turf_by_gray, b.most_gray);
  text += "};\n";
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
  parts.twigs.resize(scene.specimens.size());
  if (for_film) parts.twigs = twig_plans(scene);
  std::size_t skins = 0;
  for (const Specimen& b : scene.specimens) {
    parts.first_skin.push_back(skins);
    skins += b.look.branches.drawn() ? b.look.branches.colors() : 0;
  }
  skins = std::max<std::size_t>(1, skins);
  parts.materials =
      fmt::format("#declare Skin = array[{0}];\n#declare Skin_Pigment = array[{0}][2];\n", skins);
  if (std::ranges::any_of(scene.specimens, is_shaded)) append_bleaching(parts.materials);
  if (std::ranges::any_of(scene.specimens, [](const Specimen& b) { return !b.model.light.empty(); }))
    parts.materials +=
        fmt::format("#declare Skin_Bleached = array[{0}];\n#declare Skin_Dead = array[{0}];\n", skins);
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& b = scene.specimens[i];
    if (b.life.condition) continue;  // in each frame
    append_skin_declarations(parts.materials, b.look.branches, b.brightness, parts.first_skin[i],
                             !b.model.light.empty(), b.name);
  }
  parts.materials +=
      prototypes_text(parts.space, scene, parts.pixel) + bough_snow_declarations(parts.space, scene);
  if (std::ranges::any_of(parts.twigs, [](const auto& twigs) { return twigs != nullptr; }))
    parts.materials += kTwigInclude;
  if (for_film) parts.solids = drawn_solids(scene);
  parts.polyps.resize(scene.specimens.size());
  parts.septa.resize(scene.specimens.size());
  parallel_for(parts.polyps.size(), [&](std::size_t i) {
    const Solids& solids = parts.solids.of(scene, i);
    parts.polyps[i] = polyp_places(solids), parts.septa[i] = septum_places(solids);
  });
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
