#include "emit/frame_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "core/content.h"
#include "core/parallel.h"
#include "core/text.h"
#include "emit/copies.h"
#include "emit/plant.h"
#include "emit/setting.h"

namespace frond {

namespace {

/// The skin of each organism, at all its ages.
void append_skins(std::string& text, const Scene& scene, std::span<const std::size_t> first) {
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& b = scene.specimens[i];
    if (b.look.bark) {
      append_bark(text, b, first[i]);
      continue;
    }
    if (!b.look.skin) continue;
    const Pores& pores = b.look.skin->pores;
    const Tint& tint = b.look.skin->tint;
    std::string of = "(";
    append_integer(of, static_cast<long long>(first[i]));
    of += ',';
    append_integer(of, static_cast<int>(b.look.skin->kind));
    of += ',';
    append_color(of, tint.base);
    of += ',';
    append_color(of, tint.secondary);
    of += ',';
    append_list(of, 5, pores.cell, pores.warp, pores.depth, degrees(tint.hue), tint.saturation, tint.value,
                b.brightness, tint.young);
    of += ") ";
    text += "Coral_Skin" + of;
    if (!b.model.light.empty()) text += "Coral_Starving" + of;
    if (double glow = b.look.skin->polyps.glow; glow > 0) {
      std::string skin = "Skin[" + number_text(static_cast<double>(first[i])) + "]";
      text += "#declare " + skin + " = texture{" + skin + " Reef_Glow(" + number_text(glow) + ")} ";
    }
    append_comment(text, b.name);
  }
}

constexpr std::size_t kAside = 4'000'000;  // bytes that are not worth a file

/// Puts what is the same in all frames of a film into a file that they include, named by what is in it.
void put_aside(std::string& text, std::vector<Picture>& files) {
  if (text.size() < kAside) return;
  std::string name = fmt::format("part_{}.inc", content_id(text));
  files.push_back({name, std::move(text)});
  text = "#include \"" + name + "\"";
}

}  // namespace

FrameParts prepare_frames(const Scene& scene, CopyPlan plan, bool aside) {
  float thinnest = std::numeric_limits<float>::infinity();
  for (const Specimen& b : scene.specimens)
    for (float radius : b.model.skeleton.radius) thinnest = std::min(thinnest, radius);
  FrameParts parts;
  parts.space = space_for(thinnest);
  std::size_t skins = 0;
  for (const Specimen& b : scene.specimens) {
    parts.first_skin.push_back(skins);
    skins += b.look.bark ? b.look.bark->colors.size() : b.look.skin ? 1 : 0;
  }
  std::string count = number_text(static_cast<double>(std::max<std::size_t>(1, skins)));
  parts.materials =
      "#declare Skin = array[" + count + "];\n#declare Skin_Pigment = array[" + count + "][2];\n";
  if (std::ranges::any_of(scene.specimens, [](const Specimen& b) { return !b.model.light.empty(); }))
    parts.materials +=
        "#declare Skin_Bleached = array[" + count + "];\n#declare Skin_Dead = array[" + count + "];\n";
  append_skins(parts.materials, scene, parts.first_skin);
  parts.materials += prototypes_text(parts.space, scene);
  parts.solids = drawn_solids(scene);
  parts.polyps.resize(scene.specimens.size());
  parallel_for(parts.polyps.size(),
               [&](std::size_t i) { parts.polyps[i] = polyp_places(solids_of(parts.solids, scene, i)); });
  parts.ground = ground_text(parts.space, scene) + solids_text(parts.space, scene, parts.solids).text;
  parts.copies.resize(plan.drawn.size());
  parallel_for(parts.copies.size(), [&](std::size_t k) {
    parts.copies[k] =
        model_includes_text(scene, plan, k) + still_copies_text(parts.space, scene, plan, k).text;
  });
  parts.plan = std::move(plan);
  if (aside && scene.film.frames > 1) {
    put_aside(parts.materials, parts.files);
    put_aside(parts.ground, parts.files);
    for (std::string& some : parts.copies) put_aside(some, parts.files);
  }
  return parts;
}

}  // namespace frond
