#include <algorithm>
#include <memory>
#include <utility>

#include "images/describe_mask.h"
#include "images/read_picture.h"

namespace frond {

Errors load_mask(const NamedFile& file, Mask& mask) {
  Result<Raster> picture = read_picture(file.text);
  if (!picture) return {{file.path.string(), picture.errors().front().what}};
  mask.width = picture->width, mask.height = picture->height;
  std::vector<float> grey;
  grey.reserve(static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height));
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      auto part = [&](int channel) { return static_cast<float>(picture->at(x, y, channel)) / 255; };
      bool color = picture->channels >= 3;
      float bright = color ? 0.2126f * part(0) + 0.7152f * part(1) + 0.0722f * part(2) : part(0);
      grey.push_back(picture->channels == 4 ? bright * part(3) : bright);
    }
  bool white = std::ranges::all_of(grey, [](float share) { return share > 0.999f; });
  mask.grey = white ? nullptr : std::make_shared<const std::vector<float>>(std::move(grey));
  return {};
}

}  // namespace frond
