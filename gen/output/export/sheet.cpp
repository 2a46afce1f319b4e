#include <algorithm>
#include <array>
#include <cmath>

#include "core/linear.h"
#include "core/seed.h"
#include "export/portrait.h"

namespace frond {

namespace {

constexpr int kMargin = 1;    // pixels
constexpr double kSteep = 8;  // how fast opacity falls with the rank

/// The mean cover of a pixel and those next to it, 0..1.
float mean_cover(const Portrait& portrait, int x, int y) {
  float sum = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, portrait.high - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, portrait.wide - 1); ++u)
      sum += portrait.cover[static_cast<std::size_t>(v * portrait.wide + u)];
  return sum / 9;
}

/// For each pixel, the least share of the covered area, 0..1, at which it is opaque; 0 where nothing covers
/// it. Leaves and wood are ranked apart, or thin branches would outlast the leaves round them.
std::vector<float> ranks_of(const Portrait& portrait) {
  std::vector<float> ranks(portrait.cover.size(), 0.0f), key(portrait.cover.size(), 0.0f);
  Seed seed{35};
  for (bool leaf : {false, true}) {
    std::vector<std::size_t> order;
    double covered = 0;
    for (std::size_t i = 0; i < portrait.cover.size(); ++i) {
      float cover = portrait.cover[i];
      if (cover <= 0 || (portrait.leaves[i] >= 0.5f * cover) != leaf) continue;
      auto wide = static_cast<std::size_t>(portrait.wide);
      // Among full pixels a trunk keeps those inside it, and a crown gets gaps.
      float next = leaf ? static_cast<float>(seed.child(i).unit())
                        : mean_cover(portrait, static_cast<int>(i % wide), static_cast<int>(i / wide));
      key[i] = cover + 0.01f * next;
      order.push_back(i), covered += static_cast<double>(cover);
    }
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return key[i]; });
    for (std::size_t k = 0; k < order.size(); ++k)
      ranks[order[k]] = static_cast<float>((static_cast<double>(k) + 0.5) / covered);
  }
  return ranks;
}

}  // namespace

PictureSheet::PictureSheet(int cells, int pixels) : cell_(pixels) {
  columns_ = std::max(1, static_cast<int>(std::ceil(std::sqrt(cells))));
  int rows = (cells + columns_ - 1) / columns_;
  colors_ = Raster(columns_ * cell_, rows * cell_, 4), normals_ = Raster(columns_ * cell_, rows * cell_, 3);
  rank_.assign(colors_.data.size() / 4, 0);
}

int PictureSheet::inner() const { return cell_ - 2 * kMargin; }

void PictureSheet::put(const Portrait& portrait, int number) {
  std::vector<float> ranks = ranks_of(portrait);
  int left = number % columns_ * cell_ + kMargin, top = number / columns_ * cell_ + kMargin;
  for (int y = 0; y < portrait.high; ++y)
    for (int x = 0; x < portrait.wide; ++x) {
      auto from = static_cast<std::size_t>(y * portrait.wide + x);
      if (portrait.cover[from] <= 0) continue;
      Color color = srgb(glm::min(portrait.light[from], Vec3(1)));
      std::size_t at = colors_.index(left + x, top + y), n = normals_.index(left + x, top + y);
      colors_.data[at] = to_byte(color.red), colors_.data[at + 1] = to_byte(color.green);
      colors_.data[at + 2] = to_byte(color.blue);
      for (int c = 0; c < 3; ++c)
        normals_.data[n + static_cast<std::size_t>(c)] = to_byte(0.5 + 0.5 * portrait.normal[from][c]);
      rank_[at / 4] = ranks[from];
    }
}

void PictureSheet::cut(double share) {
  // Steep, as some programs blend what should be cut: there a full pixel would let half of the light through.
  auto opacity = [&](double rank) { return to_byte(0.5 + kSteep * (share / rank - 1)); };
  for (std::size_t i = 0; i < rank_.size(); ++i)
    colors_.data[4 * i + 3] = rank_[i] > 0 ? opacity(static_cast<double>(rank_[i])) : 0;
}

Vec2 PictureSheet::corner(int number, bool high) const {
  int x = number % columns_ * cell_ + (high ? cell_ - kMargin : kMargin);
  int y = number / columns_ * cell_ + (high ? kMargin : cell_ - kMargin);
  return {static_cast<float>(x) / static_cast<float>(colors_.width),
          1 - static_cast<float>(y) / static_cast<float>(colors_.height)};
}

Color PictureSheet::fill() {
  Vec3 sum(0);
  float count = 0;
  for (std::size_t i = 0; i < rank_.size(); ++i)
    if (rank_[i] > 0) {
      const std::uint8_t* p = &colors_.data[4 * i];
      sum += linear(Color{p[0] / 255.0f, p[1] / 255.0f, p[2] / 255.0f}), ++count;
    }
  Color mean = srgb(sum / std::max(count, 1.0f));
  std::array<std::uint8_t, 3> plain{to_byte(mean.red), to_byte(mean.green), to_byte(mean.blue)};
  for (std::size_t i = 0; i < rank_.size(); ++i)
    if (rank_[i] <= 0) {
      std::size_t near = nearest(i);
      std::copy_n(near == i ? plain.data() : &colors_.data[4 * near], 3, &colors_.data[4 * i]);
      if (near == i)
        normals_.data[3 * i] = normals_.data[3 * i + 1] = 128, normals_.data[3 * i + 2] = 255;
      else
        std::copy_n(&normals_.data[3 * near], 3, &normals_.data[3 * i]);
    }
  return mean;
}

/// A pixel in which something is within a few of it, or itself.
std::size_t PictureSheet::nearest(std::size_t i) const {
  constexpr int kFar = 3;
  int width = colors_.width, x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
  std::size_t best = i;
  int least = kFar * kFar + 1;
  for (int dy = -kFar; dy <= kFar; ++dy)
    for (int dx = -kFar; dx <= kFar; ++dx) {
      int u = x + dx, v = y + dy, far = dx * dx + dy * dy;
      if (u < 0 || v < 0 || u >= width || v >= colors_.height || far >= least) continue;
      auto at = static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
      if (rank_[at] > 0) best = at, least = far;
    }
  return best;
}

}  // namespace frond
