#include "export/look.h"

#include <algorithm>

#include "core/linear.h"

namespace frond {

std::string plain_name(const std::string& name, std::string_view otherwise) {
  std::string text;
  for (char c : name) {
    bool fine = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    text += fine ? c : '_';
  }
  return text.empty() ? std::string(otherwise) : text;
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

Vec3 young_light(const Look& look, std::size_t color) {
  Vec3 light(1);
  if (look.skin && look.skin->tint.young_length > 0) {
    light = young_light(look.skin->tint, look.skin->kind);
  } else if (look.bark && !look.coat && look.bark->young_length > 0) {
    light = linear(look.bark->young) / glm::max(linear(look.bark->colors[color]), Vec3(1e-3f));
  }
  return glm::min(light, Vec3(kMostLighter));
}

double bark_gloss(const Bark& bark) {
  return bark.kind == BarkKind::metal || bark.kind == BarkKind::wax ? 0.8 : 0.1;
}

bool is_metal(const Bark& bark) { return bark.kind == BarkKind::metal; }

bool is_leaf(Tissue tissue) {
  return tissue == Tissue::leaf || tissue == Tissue::petal || tissue == Tissue::ivy;
}

}  // namespace frond
