#include "emit/branch_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "appearance/bleaching.h"
#include "appearance/skin_colors.h"
#include "emit/plant.h"

namespace frond {

namespace {

/// What is left of its light at both ends of a chunk; it is taken by neighbours that grow as it does.
std::array<float, 2> light_along(const DrawnBranches& b, const Chunk& chunk) {
  const std::vector<float>& light = b.model.light;
  float shaded = std::clamp((b.pose.front - 0.5f) / 0.4f, 0.0f, 1.0f);
  if (light.empty() || shaded <= 0) return {1, 1};
  auto from = static_cast<std::size_t>(b.rest().parent[static_cast<std::size_t>(chunk.first)]);
  return {light[from] / shaded, light[static_cast<std::size_t>(chunk.last)] / shaded};
}

bool starves(const std::array<float, 2>& light) {
  return std::min(light[0], light[1]) < kBleaching.living_light;
}

/// The macro of a skin that is young at places.
std::string_view tip_macro(const BranchLook& look) { return look.bark ? "Plant_Tip(" : "Coral_Tip("; }

/// What stands inside the texture of a chunk: the old skin, or near a tip one that grows younger along the
/// chunk.
void append_skin(std::string& text, const PovSpace& space, const DrawnBranches& b, const Chunk& chunk,
                 std::size_t index) {
  const Skeleton& rest = b.rest();
  const Pose& pose = b.pose;
  index += b.look().color_at(b.model, chunk.first);
  Vec3 from = rest.position[rest.parent[chunk.first]], to = rest.position[chunk.last];
  if (rest.birth[chunk.last] > pose.front) {
    // Where the growing tip is on its way from the node below.
    std::int32_t below = rest.parent[chunk.last];
    float share = (pose.front - rest.birth[below]) / (rest.birth[chunk.last] - rest.birth[below]);
    to = glm::mix(rest.position[below], to, share);
  }
  Vec3 offset = to - from;
  float length2 = glm::dot(offset, offset);
  // What goes from one value to another along the chunk.
  auto append_slope = [&](float start, float end) {
    Vec3 slope = offset * ((end - start) / length2);
    double at_zero = start - glm::dot(slope, from), unit = space.unit;
    text += ',';
    append_list(text, 5, slope.x / unit, slope.y / unit, -slope.z / unit, at_zero);
  };
  auto append_macro = [&](std::string_view name) {
    text += name;
    append_index(text, index);
  };
  if (std::array<float, 2> light = light_along(b, chunk); starves(light) && length2 >= 1e-10f) {
    append_macro("Coral_Starved(");
    append_slope(chunk.young_from, chunk.young_to);
    append_slope(light[0], light[1]);
    text += ')';
  } else if (std::max(chunk.young_from, chunk.young_to) < 0.01f || length2 < 1e-10f) {
    append_macro("Skin[");
    text += ']';
  } else {
    append_macro(tip_macro(b.look()));
    append_slope(chunk.young_from, chunk.young_to);
    text += ')';
  }
}

/// The calls that declare the skins of a plant, one for each colour of its bark and for each other bark, from
/// `first` on.
void append_bark(std::string& text, const BranchLook& look, double brightness, std::size_t first,
                 std::string_view name) {
  for (std::size_t i = 0; i < look.colors(); ++i) {
    const Bark& bark = *look.bark_of(i);
    append_call(text, "Plant_Bark", first + i, static_cast<int>(bark.kind),
                bark.colors[look.other(i) ? 0 : i], bark.second, bark.young, bark.scale, bark.depth,
                brightness);
    text += ' ';
    append_comment(text, name);
  }
}

}  // namespace

void append_skin_declarations(std::string& text, const BranchLook& look, double brightness, std::size_t first,
                              bool starving, std::string_view name) {
  if (look.bark) return append_bark(text, look, brightness, first, name);
  if (!look.skin) return;
  const Skin& skin = *look.skin;
  auto bright = static_cast<float>(brightness);
  auto declare = [&](std::string_view macro, const SkinColors& one, const SkinColors& other) {
    append_call(text, macro, first, static_cast<int>(skin.kind), bright * one.tissue, bright * one.pits,
                bright * other.tissue, bright * other.pits, skin.pores.cell, skin.pores.warp,
                skin.pores.depth);
    text += ' ';
  };
  declare("Coral_Skin", old_skin(skin), young_skin(skin));
  if (starving) declare("Coral_Starving", bleached_skin(skin), dead_skin(skin));
  if (double glow = look.skin->polyps.glow; glow > 0)
    text +=
        fmt::format("#declare Skin[{0}] = texture{{Skin[{0}] Reef_Glow({1})}} ", first, number_text(glow));
  append_comment(text, name);
}

std::string skin_texture(std::size_t index) { return fmt::format("texture{{Skin[{}]}}", index); }

void append_chunk_texture(std::string& text, const PovSpace& space, const DrawnBranches& branches,
                          Chunk chunk, std::size_t index) {
  text += "texture{";
  append_skin(text, space, branches, chunk, index);
  if (branches.look().ringed(branches.look().color_at(branches.model, chunk.first)) ||
      branches.slanted(chunk))
    lay_along(branches.rest(), chunk);
  // Where a branch is too thin for one there is no pattern to be seen.
  if (chunk.moved() && branches.look().patterned())
    static_cast<void>(append_matrix(text, space, chunk.matrix, chunk.shift));
  text += '}';
}

std::optional<std::size_t> SharedTextures::of(const Chunk& chunk) const {
  constexpr float kLeastChange = 0.1f;  // of youth, that is seen along a chunk
  const std::vector<Vec3>& at = branches.rest().position;
  float length = glm::distance(at[branches.rest().parent[chunk.first]], at[chunk.last]);
  if ((length > dot && std::abs(chunk.young_to - chunk.young_from) > kLeastChange) ||
      starves(light_along(branches, chunk)))
    return std::nullopt;
  float young = std::clamp((chunk.young_from + chunk.young_to) / 2, 0.0f, 1.0f);
  return branches.look().color_at(branches.model, chunk.first) * kAges +
         static_cast<std::size_t>(std::lround(young * (kAges - 1)));
}

std::string SharedTextures::text(std::size_t number, std::size_t index) const {
  index += number / kAges;
  if (number % kAges == 0) return skin_texture(index);
  return fmt::format("texture{{{}{},0,0,0,{})}}", tip_macro(branches.look()), index,
                     number_text(static_cast<double>(number % kAges) / (kAges - 1)));
}

namespace {

/// The names of a coat's pictures, as a macro takes them.
std::string names_of(const BarkCoat& coat) {
  return fmt::format("\"{}\",\"{}\"", bark_color_name(coat), bark_height_name(coat));
}

/// The declared bumps of a coat, which are as strong as it says.
std::string relief_id(const BarkCoat& coat) {
  std::string id = picture_id("Relief", bark_height_name(coat)) + '_' + number_text(coat.relief, 4);
  std::ranges::replace(id, '.', '_');
  return id;
}

ObjectText coat_text(const PovSpace& space, const DrawnBranches& branches, const BarkCoat& coat,
                     const Surface& wood, double pixel) {
  if (!has_faces(wood)) return {};
  std::string text = "object{\n";
  append_mesh(text, space, wood, {.decimals = decimals_for(space, pixel)});
  text += fmt::format("\ntexture{{Tree_Bark({},", names_of(coat));
  append_list(text, 4, coat.relief, branches.traits.brightness);
  text += ")}";
  if (coat.moss > 0) {
    text += "\ntexture{Tree_Moss(";
    append_list(text, 4, coat.moss, coat.moss_height, branches.pose.position[0].y);
    text += ")}";
  }
  text += shift_over(branches.traits.shift, coat.tone);
  text += weather_over(branches.traits.snowy, branches.traits.wet, Wetting::wood);
  return {text + "}\n", 1};
}

}  // namespace

ObjectText coat_text(const PovSpace& space, const DrawnBranches& branches, Vec3 eye, double pixel) {
  ObjectText text;
  for (const auto& [coat, wood] : branches.coat_surfaces(eye, pixel))
    text += coat_text(space, branches, *coat, wood, pixel);
  return text;
}

std::string cube_texture(const BranchLook& look, std::size_t color, double brightness, double side, int age,
                         int shade) {
  Vec3 light = look.cube(color, static_cast<float>(age) / (kCubeAges - 1),
                         static_cast<float>(shade) / (kCubeShades - 1));
  return "texture{" + call_text("Voxel_Skin", static_cast<float>(brightness) * light, number_text(side, 4)) +
         '}';
}

std::string picture_id(std::string_view as, std::string_view file) {
  return fmt::format("{}_{}", as, file.substr(0, file.find('.')));
}

void declare_once(std::string& text, std::string_view id, std::string_view what) {
  text += fmt::format("#ifndef ({0}) #declare {0} = {1} #end\n", id, what);
}

void declare_pictures(std::string& text, const std::vector<std::string>& files, bool lit) {
  for (const std::string& file : files) {
    declare_once(text, picture_id("Picture", file), fmt::format("pigment{{Copy_File(\"{}\",0)}}", file));
    if (lit)
      declare_once(text, picture_id("Half", file), fmt::format("pigment{{Copy_File(\"{}\",0.5)}}", file));
  }
}

std::string array_of(std::string_view as, const std::vector<std::string>& files) {
  return array_text(files, [&](std::string& text, const std::string& file) { text += picture_id(as, file); });
}

std::string array_of(const std::vector<Color>& colors) {
  return array_text(colors, [](std::string& text, const Color& color) { append_color(text, color); });
}

bool is_lit(const std::optional<Luster>& luster) { return luster && luster->yellow > 0; }

void declare_coat(std::string& text, const BranchLook& look, std::size_t color) {
  const BarkCoat* coat = look.coat_of(color);
  if (!coat) return;
  declare_pictures(text, {bark_color_name(*coat)}, false);
  declare_once(
      text, relief_id(*coat),
      fmt::format("normal{{Copy_Relief(\"{}\",{})}}", bark_height_name(*coat), number_text(coat->relief, 4)));
}

std::string copy_texture(const BranchLook& look, std::size_t color) {
  if (const BarkCoat* coat = look.coat_of(color))
    return call_text("Copy_Bark", picture_id("Picture", bark_color_name(*coat)), relief_id(*coat), coat->tone,
                     "T");
  if (look.skin) {
    const Skin& skin = *look.skin;
    SkinColors old = old_skin(skin), young = young_skin(skin);
    return call_text("Copy_Coral", static_cast<int>(skin.kind), old.tissue, old.pits, young.tissue,
                     young.pits, skin.pores.cell, skin.pores.warp, skin.pores.depth, "T");
  }
  Bark plain;
  plain.kind = BarkKind::stem;
  const Bark* worn = look.bark_of(color);
  const Bark& b = worn ? *worn : plain;
  return call_text("Copy_Wood", static_cast<int>(b.kind), b.colors[0], b.second, b.scale, b.depth, "T");
}

bool is_pictured(const BranchLook& look, std::size_t color) { return look.coat_of(color) || look.coral(); }

std::string_view copy_include(const BranchLook& look) { return look.coral() ? "coral" : ""; }

std::string_view include_of(const BranchLook& look) {
  return look.coral() ? "coral" : look.plant() ? "plant" : "";
}

}  // namespace frond
