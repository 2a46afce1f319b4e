#include "masonry/tone.h"

#include <algorithm>

namespace frond {

Color toned(const Color& color, double brightness, double warmth) {
  auto channel = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
  return {channel(color.red * brightness * (1 + warmth)), channel(color.green * brightness),
          channel(color.blue * brightness * (1 - warmth))};
}

}  // namespace frond
