#include "export/look.h"

#include <algorithm>

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

double bark_gloss(const Bark& bark) {
  return bark.kind == BarkKind::metal || bark.kind == BarkKind::wax ? 0.8 : 0.1;
}

bool is_metal(const Bark& bark) { return bark.kind == BarkKind::metal; }

bool is_leaf(Tissue tissue) {
  return tissue == Tissue::leaf || tissue == Tissue::petal || tissue == Tissue::ivy;
}

}  // namespace frond
