#include "images/leaf_photo.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "images/photo.h"

namespace frond {

namespace {

constexpr int kRadii = 128;          // of the outline
constexpr int kRaysARadius = 3;      // on each side
constexpr double kThin = 0.045;      // share of the leaf's length that a stalk is at most wide
constexpr double kThinShare = 0.35;  // and of the widest place
constexpr double kLongestStalk = 0.8;
constexpr std::uint8_t kOpaque = 128;

/// A stretch of opaque pixels in a row, up to and without `end`.
struct Run {
  int begin = 0, end = 0;
  int width() const { return end - begin; }
};

std::vector<Run> runs_of(const Grid& cover, int y) {
  std::vector<Run> runs;
  for (int x = 0; x < cover.width; ++x) {
    if (cover.at(x, y) < 0.5f) continue;
    if (runs.empty() || runs.back().end != x) runs.push_back({x, x});
    runs.back().end = x + 1;
  }
  return runs;
}

/// Opacity between pixels, none outside of the picture.
double cover_at(const Grid& cover, double x, double y) {
  auto at = [&](int i, int k) {
    return i >= 0 && k >= 0 && i < cover.width && k < cover.height ? static_cast<double>(cover.at(i, k))
                                                                   : 0.0;
  };
  double left = std::floor(x - 0.5), top = std::floor(y - 0.5), right = x - 0.5 - left, down = y - 0.5 - top;
  int i = static_cast<int>(left), k = static_cast<int>(top);
  return (at(i, k) * (1 - right) + at(i + 1, k) * right) * (1 - down) +
         (at(i, k + 1) * (1 - right) + at(i + 1, k + 1) * right) * down;
}

/// Takes the stalk out of the opacity: what is thin from the lowest row `foot` on. The first row above it.
int without_stalk(Grid& cover, int top, int foot, int widest) {
  int high = foot + 1 - top;
  int thin = std::max(2, static_cast<int>(std::min(kThin * high, kThinShare * widest)));
  Grid whole = cover;
  std::vector<Run> runs = runs_of(cover, foot);
  auto off = [&](const Run& r) { return std::abs(r.begin + r.end - cover.width); };
  Run stalk = *std::ranges::min_element(runs, {}, off);
  for (int y = foot; y > foot - kLongestStalk * high; --y) {
    // What the stalk goes on to is the widest that it touches.
    Run next;
    for (const Run& r : runs_of(cover, y))
      if (r.begin <= stalk.end && r.end >= stalk.begin && r.width() > next.width()) next = r;
    if (next.width() == 0 || next.width() > thin) return y;
    for (int x = next.begin; x < next.end; ++x) cover.at(x, y) = 0;
    stalk = next;
  }
  cover = std::move(whole);  // all of it is thin, as a needle
  return foot;
}

/// Radius of a disc's sector with the area that is opaque in that direction, so that what lies behind a gap
/// counts too.
double radius_of(const Grid& cover, Vec2 middle, double angle) {
  constexpr double kStep = 0.5;
  double dx = std::sin(angle), dy = -std::cos(angle), sum = 0, most = std::hypot(cover.width, cover.height);
  for (double r = kStep / 2; r < most; r += kStep)
    sum += kStep * r * cover_at(cover, middle.x + r * dx, middle.y + r * dy);
  return std::sqrt(2 * sum);
}

/// Finds the outline and where it lies; false where nothing is opaque on the axis.
bool find_outline(LeafPhoto& photo) {
  const Raster& picture = photo.levels.front();
  Grid cover(picture.width, picture.height);
  for (std::size_t i = 0; i < cover.data.size(); ++i)
    cover.data[i] = static_cast<float>(picture.data[4 * i + 3]) / 255;
  int top = picture.height, foot = -1, widest = 0;
  for (int y = 0; y < picture.height; ++y)
    for (const Run& r : runs_of(cover, y))
      top = std::min(top, y), foot = y, widest = std::max(widest, r.width());
  if (foot < 0) return false;
  int base = without_stalk(cover, top, foot, widest) + 1;

  double area = 0, moment = 0;
  for (int y = 0; y < base; ++y)
    for (int x = 0; x < cover.width; ++x) area += cover.at(x, y), moment += (y + 0.5) * cover.at(x, y);
  double blade = base - top, at = moment / std::max(area, 1e-9);
  Vec2 middle(picture.width / 2.0, std::clamp(at, top + 0.15 * blade, base - 0.15 * blade));
  std::vector<double>& radii = photo.outline.radii;
  radii.assign(kRadii, 0);
  for (int i = 0; i < kRadii; ++i)
    for (int ray = 0; ray < kRaysARadius; ++ray) {
      double angle = kPi * (i + (ray + 0.5) / kRaysARadius - 0.5) / (kRadii - 1);
      for (int side : {1, -1}) radii[i] += radius_of(cover, middle, side * angle) / (2 * kRaysARadius);
    }
  radii.back() = base - static_cast<double>(middle.y);
  if (radii.front() < 1 || radii.back() < 1) return false;
  photo.foot = Vec2(middle.x, foot + 1);
  photo.length = foot + 1 - static_cast<double>(middle.y) + radii.front();
  for (double& r : radii) r /= photo.length;
  photo.outline.stalk = (foot + 1 - base) / photo.length;
  return true;
}

/// The picture half as large, of which each pixel has the mean colour of what is opaque in it.
Raster halved(const Raster& from) {
  Raster to((from.width + 1) / 2, (from.height + 1) / 2, 4);
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x) {
      Vec3 sum(0);
      float cover = 0;
      for (int k = 0; k < 4; ++k) {
        int i = std::min(2 * x + k % 2, from.width - 1), j = std::min(2 * y + k / 2, from.height - 1);
        float share = static_cast<float>(from.at(i, j, 3)) / 255;
        for (int c = 0; c < 3; ++c) sum[c] += share * linear(from.at(i, j, c));
        cover += share;
      }
      for (int c = 0; c < 3 && cover > 0; ++c)
        to.data[to.index(x, y, c)] = to_byte(encoded(static_cast<double>(sum[c] / cover)));
      to.data[to.index(x, y, 3)] = to_byte(static_cast<double>(cover / 4));
    }
  return to;
}

/// Adds smaller pictures, down to a pixel, and fills from them what is not opaque (pull-push: Gortler,
/// Grzeszczuk, Szeliski and Cohen 1996).
void fill_levels(std::vector<Raster>& levels) {
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
  for (std::size_t k = levels.size() - 1; k-- > 0;) {
    Raster& fine = levels[k];
    const Raster& coarse = levels[k + 1];
    for (int y = 0; y < fine.height; ++y)
      for (int x = 0; x < fine.width; ++x) {
        int open = 255 - fine.at(x, y, 3);
        for (int c = 0; c < 3 && open > 0; ++c)
          fine.data[fine.index(x, y, c)] = static_cast<std::uint8_t>(
              (coarse.at(x / 2, y / 2, c) * open + fine.at(x, y, c) * (255 - open) + 127) / 255);
      }
  }
}

Vec3 between_pixels(const Raster& picture, double x, double y) {
  x = std::clamp(x - 0.5, 0.0, picture.width - 1.0), y = std::clamp(y - 0.5, 0.0, picture.height - 1.0);
  int left = static_cast<int>(x), top = static_cast<int>(y);
  int right = std::min(left + 1, picture.width - 1), below = std::min(top + 1, picture.height - 1);
  auto at = [&](int i, int k) {
    return Vec3(linear(picture.at(i, k, 0)), linear(picture.at(i, k, 1)), linear(picture.at(i, k, 2)));
  };
  auto across = static_cast<float>(x - left), down = static_cast<float>(y - top);
  return glm::mix(glm::mix(at(left, top), at(right, top), across),
                  glm::mix(at(left, below), at(right, below), across), down);
}

}  // namespace

Vec3 LeafPhoto::at(Vec2 p, double pixel) const {
  double x = foot.x + p.x * length, y = foot.y - p.y * length;
  double level =
      std::clamp(std::log2(std::max(pixel * length, 1.0)), 0.0, static_cast<double>(levels.size() - 1));
  auto of = [&](std::size_t k) {
    double size = std::exp2(static_cast<double>(k));
    return between_pixels(levels[k], x / size, y / size);
  };
  auto fine = static_cast<std::size_t>(level);
  auto share = static_cast<float>(level - static_cast<double>(fine));
  return share > 0 ? glm::mix(of(fine), of(fine + 1), share) : of(fine);
}

Result<LeafPhoto> read_leaf_photo(std::string_view bytes) {
  Result<Raster> read = read_photo(bytes);
  if (!read) return read.errors();
  constexpr const char* kExpected =
      "; expected a leaf that was cut out, with nothing but transparency around it, as a PNG or WebP";
  bool open = false;
  for (std::size_t i = 3; read->channels == 4 && i < read->data.size(); i += 4)
    open |= read->data[i] < kOpaque;
  if (!open) return Error{"", std::string("has no transparency") + kExpected};
  LeafPhoto photo;
  photo.levels.push_back(std::move(*read));
  if (!find_outline(photo))
    return Error{"", std::string("has no leaf in the middle of its width") + kExpected};
  fill_levels(photo.levels);
  const std::vector<std::uint8_t>& last = photo.levels.back().data;
  photo.mean = {static_cast<float>(last[0]) / 255, static_cast<float>(last[1]) / 255,
                static_cast<float>(last[2]) / 255};
  return photo;
}

}  // namespace frond
