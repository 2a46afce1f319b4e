#include "dress/dress.h"

#include <algorithm>
#include <iterator>

#include "core/linear.h"

namespace frond {

LeafLook leaves_of(const TreeDress& dress) {
  return dress.season ? with_seasons(dress.leaves, *dress.season) : dress.leaves;
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

bool BranchLook::patterned() const {
  return skin || (bark && (bark->kind == BarkKind::bark || bark->kind == BarkKind::birch || ringed()));
}

double BranchLook::pattern_size() const { return !patterned() ? 0 : skin ? skin->pores.cell : bark->scale; }

double BranchLook::gloss() const {
  return bark && (bark->kind == BarkKind::metal || bark->kind == BarkKind::wax) ? 0.8 : 0.1;
}

Color BranchLook::plain(std::size_t color, double brightness) const {
  if (skin) {
    // Walls and pores, as they run together from afar.
    Tint pores = skin->tint;
    pores.base = pores.secondary;
    return mixed(tinted(skin->tint, brightness), tinted(pores, brightness), 0.3f);
  }
  const Bark& wood = bark ? *bark : Bark{};
  float furrows = bark && wood.kind == BarkKind::bark ? 0.25f : 0.0f;
  return scaled(mixed(wood.colors[color], wood.second, furrows), brightness);
}

Color BranchLook::young(std::size_t color, double brightness) const {
  if (skin)
    return mixed(tinted(skin->tint, brightness), {0.96f, 0.96f, 0.96f},
                 static_cast<float>(0.62 * skin->tint.young));
  return bark ? scaled(bark->young, brightness) : plain(color, brightness);
}

namespace {

constexpr float kMostLighter = 8;  // or the tints of old skin would be too dark for eight bits

Vec3 young_light(const Tint& tint, SkinKind kind) {
  auto young = static_cast<float>(tint.young);
  if (kind != SkinKind::stony) return Vec3(1 + (kind == SkinKind::fan ? 0.35f : 0.25f) * young);
  Vec3 base = glm::max(linear(tinted(tint, 1)), Vec3(1e-3f));
  Vec3 tip = base * 0.55f + Vec3(1, 0.93f, 0.85f) * (0.45f * static_cast<float>(tint.value));
  return glm::mix(base, tip, 0.85f * young * young) / base;
}

}  // namespace

Vec3 BranchLook::young_light(std::size_t color) const {
  Vec3 light(1);
  if (skin && skin->tint.young_length > 0) {
    light = frond::young_light(skin->tint, skin->kind);
  } else if (bark && !coat && bark->young_length > 0) {
    light = linear(bark->young) / glm::max(linear(bark->colors[color]), Vec3(1e-3f));
  }
  return glm::min(light, Vec3(kMostLighter));
}

Vec3 BranchLook::albedo() const {
  if (skin) return linear(skin->tint.base);
  return bark ? mean(bark->colors) : Vec3(0.2f);
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

Color scaled(Color c, double factor) {
  auto part = [&](float x) { return static_cast<float>(std::clamp(x * factor, 0.0, 1.0)); };
  return {part(c.red), part(c.green), part(c.blue)};
}

Color tinted(const Tint& tint, double brightness) {
  // Turned round grey, with saturation and value.
  Vec3 c(tint.base.red, tint.base.green, tint.base.blue);
  c = glm::angleAxis(static_cast<float>(tint.hue), glm::normalize(Vec3(1))) * c;
  float grey = c.x * 0.30f + c.y * 0.59f + c.z * 0.11f;
  c = glm::mix(Vec3(grey), c, static_cast<float>(tint.saturation));
  return scaled({c.x, c.y, c.z}, tint.value * brightness);
}

Vec3 mean(const std::vector<Color>& colors) {
  Vec3 sum(0);
  for (const Color& color : colors) sum += linear(color);
  return colors.empty() ? Vec3(0.2f) : sum / static_cast<float>(colors.size());
}

Dress dress_of(const TreeDress& tree, bool leafy) {
  Dress dress;
  dress.look.branches = {.bark = tree.bark, .coat = tree.coat};
  if (leafy) dress.look.leaves = leaves_of(tree);
  dress.season = tree.season;
  dress.motion = {tree.growth, tree.wave, {}, 1};
  dress.variation = tree.bark.variation;
  return dress;
}

std::vector<Drawing> drawings(const Look& look) {
  std::vector<Drawing> all;
  if (look.leaves) all = leaf_drawings(*look.leaves);
  for (const LeafLook& organ : look.organs) std::ranges::move(leaf_drawings(organ), std::back_inserter(all));
  std::ranges::copy(look.pictures, std::back_inserter(all));
  if (look.branches.coat) all.push_back(bark_drawing(*look.branches.coat));
  return all;
}

}  // namespace frond
