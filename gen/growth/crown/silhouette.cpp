#include "crown/silhouette.h"

#include <algorithm>
#include <cmath>

#include "core/polygon.h"

namespace frond {

namespace {

constexpr float kLongest = 100;  // times as wide as high, or as high as wide

/// Nothing where a silhouette may be so wide and high.
Errors refuse_size(float width, float height) {
  if (!(height > 0) || !(width > 0)) return {{"", "the silhouette is flat"}};
  float ratio = width / height;
  if (ratio <= kLongest && ratio >= 1 / kLongest) return {};
  return {error_at("", "the silhouette is {:.3g} times as {}; expected {:g} times at most",
                   std::max(ratio, 1 / ratio), ratio > 1 ? "wide as high" : "high as wide", kLongest)};
}

}  // namespace

Result<Silhouette> Silhouette::from_outlines(std::vector<std::vector<Vec2>> outlines) {
  std::erase_if(outlines, [](const std::vector<Vec2>& o) { return o.size() < 3; });
  if (outlines.empty()) return Error{"", "the silhouette has no closed outline"};
  Vec2 low = outlines[0][0], high = low;
  for (const auto& o : outlines)
    for (Vec2 p : o) low = glm::min(low, p), high = glm::max(high, p);
  float height = high.y - low.y, middle = (low.x + high.x) / 2;
  if (Errors errors = refuse_size(high.x - low.x, height); !errors.empty()) return errors;
  for (auto& o : outlines)
    for (Vec2& p : o) p = (p - Vec2(middle, low.y)) / height;
  Silhouette made;
  made.outlines_ = std::move(outlines);
  made.width_ = (high.x - low.x) / height;
  return made;
}

Result<Silhouette> Silhouette::from_picture(const Raster& picture) {
  bool alpha = false;
  for (std::size_t i = 3; picture.channels == 4 && i < picture.data.size(); i += 4)
    alpha = alpha || picture.data[i] < 250;
  auto is_filled = [&](int x, int y) {
    if (alpha) return picture.at(x, y, 3) >= 128;
    int sum = 0, colors = std::min(picture.channels, 3);
    for (int c = 0; c < colors; ++c) sum += picture.at(x, y, c);
    return sum < 128 * colors;
  };
  int left = picture.width, right = -1, top = picture.height, bottom = -1;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (!is_filled(x, y)) continue;
      left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
      bottom = std::max(bottom, y);
    }
  }
  if (right < 0) return Error{"", "the picture of the silhouette is empty: nothing in it is dark or opaque"};
  Silhouette made;
  made.columns_ = right - left + 1;
  made.rows_ = bottom - top + 1;
  Errors errors = refuse_size(static_cast<float>(made.columns_), static_cast<float>(made.rows_));
  if (!errors.empty()) return errors;
  made.width_ = static_cast<float>(made.columns_) / static_cast<float>(made.rows_);
  for (int y = bottom; y >= top; --y)
    for (int x = left; x <= right; ++x) made.filled_.push_back(is_filled(x, y));
  return made;
}

bool Silhouette::inside(Vec2 at) const {
  if (columns_ > 0) {
    auto rows = static_cast<float>(rows_);
    int x = static_cast<int>(std::floor((at.x + width_ / 2) * rows)),
        y = static_cast<int>(std::floor(at.y * rows));
    return x >= 0 && x < columns_ && y >= 0 && y < rows_ && filled_[y * columns_ + x];
  }
  bool in = false;
  for (const auto& outline : outlines_) in ^= encloses(outline, at);
  return in;
}

}  // namespace frond
