#include "appearance/appearance.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "appearance/skin_colors.h"
#include "core/linear.h"

namespace frond {

namespace {

Color shown(Vec3 light) { return srgb(glm::clamp(light, Vec3(0), Vec3(1))); }

Vec3 tip_of(const Skin& skin, Built built) {
  return built == Built::cubes ? young_cube(skin.tint) : young_skin(skin).tissue;
}

}  // namespace

LeafLook leaves_of(const TreeAppearance& appearance) {
  return appearance.season ? with_seasons(appearance.leaves, *appearance.season) : appearance.leaves;
}

const Polyps* BranchLook::polyps() const {
  return skin && (skin->polyps.width > 0 || skin->polyps.glow > 0) ? &skin->polyps : nullptr;
}

std::size_t BranchLook::color_at(const Model& model, std::int32_t node) const {
  return model.color.empty() ? 0 : color_index(model.color[static_cast<std::size_t>(node)], colors());
}

double BranchLook::young_length() const {
  return skin ? skin->tint.young_length : bark ? bark->young_length : 0;
}

const Bark* BranchLook::bark_of(std::size_t color) const {
  if (std::size_t k = other(color)) return &others[k - 1].bark;
  return bark ? &*bark : nullptr;
}

const BarkCoat* BranchLook::coat_of(std::size_t color) const {
  std::size_t k = other(color);
  const std::optional<BarkCoat>& worn = k > 0 ? others[k - 1].coat : coat;
  return worn ? &*worn : nullptr;
}

bool BranchLook::patterned() const {
  if (patterned(0)) return true;
  for (std::size_t color = own_colors(); color < colors(); ++color)
    if (patterned(color)) return true;
  return false;
}

bool BranchLook::patterned(std::size_t color) const {
  if (skin) return true;
  const Bark* worn = bark_of(color);
  return worn &&
         (worn->kind == BarkKind::bark || worn->kind == BarkKind::birch || worn->kind == BarkKind::palm);
}

bool BranchLook::ringed(std::size_t color) const {
  const Bark* worn = bark_of(color);
  return worn && worn->kind == BarkKind::palm;
}

double BranchLook::pattern_size() const { return !patterned() ? 0 : skin ? skin->pores.cell : bark->scale; }

double BranchLook::gloss(std::size_t color) const {
  const Bark* worn = bark_of(color);
  return worn && (worn->kind == BarkKind::metal || worn->kind == BarkKind::wax) ? 0.8 : 0.1;
}

bool BranchLook::metal(std::size_t color) const {
  const Bark* worn = bark_of(color);
  return worn && worn->kind == BarkKind::metal;
}

Color BranchLook::plain(std::size_t color, double brightness) const {
  if (skin) {
    // Walls and pores, as they run together from afar.
    SkinColors old = old_skin(*skin);
    auto bright = static_cast<float>(brightness);
    return mixed(shown(bright * old.tissue), shown(bright * old.pits), 0.3f);
  }
  const Bark* worn = bark_of(color);
  const Bark wood = worn ? *worn : Bark{};
  float furrows = worn && wood.kind == BarkKind::bark ? 0.25f : 0.0f;
  return scaled(mixed(wood.colors[other(color) ? 0 : color], wood.second, furrows), brightness);
}

Color BranchLook::young(std::size_t color, double brightness, Built built) const {
  if (skin) return shown(static_cast<float>(brightness) * tip_of(*skin, built));
  const Bark* worn = bark_of(color);
  return worn ? scaled(worn->young, brightness) : plain(color, brightness);
}

Vec3 BranchLook::young_light(std::size_t color, Built built) const {
  constexpr float kMostLighter = 8;  // or the tints of old skin would be too dark for eight bits
  Vec3 light(1);
  if (skin && skin->tint.young_length > 0) {
    light = tip_of(*skin, built) / glm::max(old_skin(*skin).tissue, Vec3(1e-3f));
  } else if (bark && !coat && bark->young_length > 0) {
    const Bark& worn = *bark_of(color);
    light = linear(worn.young) / glm::max(linear(worn.colors[other(color) ? 0 : color]), Vec3(1e-3f));
  }
  return glm::min(light, Vec3(kMostLighter));
}

Vec3 BranchLook::cube(std::size_t color, float age, float shade) const {
  Vec3 old, second, tip;
  if (skin) {
    SkinColors colors = old_skin(*skin);
    old = colors.tissue, second = colors.pits, tip = young_cube(skin->tint);
  } else {
    const Bark& worn = *bark_of(color);
    old = linear(worn.colors[other(color) ? 0 : color]), second = linear(worn.second),
    tip = linear(worn.young);
  }
  float dark = 0.16f * (1 - shade);
  return glm::mix(glm::mix(old, tip, age) * (0.80f + 0.40f * shade), second, dark);
}

Vec3 BranchLook::albedo() const {
  if (skin) return linear(skin->tint.base);
  return bark ? mean(bark->colors) : Vec3(0.2f);
}

Vec3 BranchLook::albedo_at(const Model& model, std::int32_t node) const {
  std::size_t k = others.empty() ? 0 : other(color_at(model, node));
  return k > 0 ? linear(others[k - 1].bark.colors[0]) : albedo();
}

TubeShape BranchLook::tube_shape(std::span<const float> girth) const {
  return {.wrap = coat->wrap,
          .aspect = coat->aspect,
          .side = coat->facet,
          .lobes = lobes,
          .lobe_depth = lobe_depth,
          .least = static_cast<float>(coat->twigs),
          .girth = girth};
}

std::vector<Surface> by_bark(const BranchLook& look, const Model& model, const TubeMesh& tubes) {
  if (look.others.empty() || model.color.empty()) return {tubes.surface};
  std::vector<Surface> parts(1 + look.others.size());
  std::vector<std::vector<std::uint32_t>> index(parts.size(),
                                                std::vector<std::uint32_t>(tubes.node.size(), UINT32_MAX));
  const Surface& all = tubes.surface;
  for (const auto& triangle : all.triangle) {
    // Between two rings is the segment that ends at the farther one.
    std::int32_t node = std::max({tubes.node[triangle[0]], tubes.node[triangle[1]], tubes.node[triangle[2]]});
    const std::size_t k = look.other(look.color_at(model, node));
    Surface& part = parts[k];
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = triangle[c];
      std::uint32_t& at = index[k][from];
      if (at == UINT32_MAX) {
        at = static_cast<std::uint32_t>(part.position.size());
        part.position.push_back(all.position[from]);
        part.normal.push_back(all.normal[from]);
        if (!all.uv.empty()) part.uv.push_back(all.uv[from]);
      }
      corners[c] = at;
    }
    part.triangle.push_back(corners);
  }
  return parts;
}

Color scaled(Color c, double factor) {
  auto part = [&](float x) { return static_cast<float>(std::clamp(x * factor, 0.0, 1.0)); };
  return {part(c.red), part(c.green), part(c.blue)};
}

Vec3 mean(const std::vector<Color>& colors) {
  Vec3 sum(0);
  for (const Color& color : colors) sum += linear(color);
  return colors.empty() ? Vec3(0.2f) : sum / static_cast<float>(colors.size());
}

void set_season(Appearance& appearance, const std::optional<Seasons>& season) {
  appearance.season = season;
  if (season && season->fruit)
    std::ranges::move(fruit_drawings(*season->fruit), std::back_inserter(appearance.look.pictures));
}

Appearance tree_appearance(const TreeAppearance& tree, bool leafy) {
  Appearance appearance;
  appearance.look.branches = {.bark = tree.bark, .coat = tree.coat};
  if (leafy) appearance.look.leaves = leaves_of(tree);
  set_season(appearance, tree.season);
  appearance.motion = {tree.growth, tree.wave, {}, 1};
  appearance.motion.wood.emplace();
  appearance.variation = tree.bark.variation;
  return appearance;
}

std::vector<Drawing> drawings(const Look& look) {
  std::vector<Drawing> all;
  if (look.leaves) all = leaf_drawings(*look.leaves);
  for (const LeafLook& organ : look.organs) std::ranges::move(leaf_drawings(organ), std::back_inserter(all));
  std::ranges::copy(look.pictures, std::back_inserter(all));
  if (look.branches.coat) all.push_back(bark_drawing(*look.branches.coat));
  for (const OtherBark& other : look.branches.others)
    if (other.coat) all.push_back(bark_drawing(*other.coat));
  return all;
}

}  // namespace frond
