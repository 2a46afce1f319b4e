#include "preview/quick_look.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/bounds.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "draw/surfel_sampler.h"
#include "scene/camera.h"
#include "scene/far.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr float kNear = 0.02f;     // metres
constexpr float kFar = 4000;       // metres that flat land is seen
constexpr int kShadowSide = 1024;  // of the picture that the sun sees
constexpr float kLargest = 24;     // pixels that a bit covers to each side at most
constexpr std::uint64_t kNothing = UINT64_MAX;

/// Pixels that keep what is nearest; from many threads at once, and the same whatever their order.
class Pixels {
 public:
  Pixels(int wide, int high)
      : width(wide), height(high), cells_(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high)) {
    for (auto& cell : cells_) cell.store(kNothing, std::memory_order_relaxed);
  }

  /// A square about a place, `half` pixels to each side.
  void put(float x, float y, float half, float depth, std::uint32_t color) {
    half = std::clamp(half, 0.0f, kLargest);
    std::uint64_t wanted = (static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(depth)) << 32) | color;
    int left = std::max(0, static_cast<int>(std::floor(x - half))),
        right = std::min(width - 1, static_cast<int>(std::floor(x + half)));
    int top = std::max(0, static_cast<int>(std::floor(y - half))),
        low = std::min(height - 1, static_cast<int>(std::floor(y + half)));
    for (int row = top; row <= low; ++row)
      for (int column = left; column <= right; ++column) {
        auto& cell = cells_[index(column, row)];
        std::uint64_t before = cell.load(std::memory_order_relaxed);
        while (wanted < before && !cell.compare_exchange_weak(before, wanted, std::memory_order_relaxed)) {
        }
      }
  }

  bool empty(int x, int y) const { return at(x, y) == kNothing; }
  float depth(int x, int y) const { return std::bit_cast<float>(static_cast<std::uint32_t>(at(x, y) >> 32)); }
  std::uint32_t color(int x, int y) const { return static_cast<std::uint32_t>(at(x, y)); }

  const int width, height;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  std::uint64_t at(int x, int y) const { return cells_[index(x, y)].load(std::memory_order_relaxed); }
  std::vector<std::atomic<std::uint64_t>> cells_;
};

std::uint32_t packed(Vec3 c) {
  auto part = [](float x) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255));
  };
  return part(c.x) << 16 | part(c.y) << 8 | part(c.z);
}

Vec3 unpacked(std::uint32_t c) { return Vec3(c >> 16 & 255, c >> 8 & 255, c & 255) / 255.0f; }

/// What the camera sees.
struct ToPicture {
  const Lens& lens;
  Pixels& pixels;

  float pixel(float depth) const {
    return 2 * lens.wide * std::max(depth, 0.05f) / static_cast<float>(pixels.width);
  }
  /// A place may be the middle of a trunk whose bark is much nearer.
  float step(Vec3 at) const {
    float away = glm::distance(at, lens.at);
    return 0.8f * pixel(std::max(0.3f * away, away - 2));
  }
  void add(Vec3 at, float area, Vec3 albedo, Facing, float) const {
    Vec3 seen = lens.seen(at);
    if (seen.z < kNear || std::abs(seen.x) > 1.2f || std::abs(seen.y) > 1.2f) return;
    pixels.put(0.5f * (1 + seen.x) * static_cast<float>(pixels.width),
               0.5f * (1 - seen.y) * static_cast<float>(pixels.height),
               0.5f * std::sqrt(area) / pixel(seen.z), seen.z, packed(glm::sqrt(albedo)));
  }
};

/// What the sun sees: how far down its way something stands.
struct ToSun {
  Vec3 right, up, way;  // of length 1, toward the sun
  Vec3 middle;
  float half = 1;  // metres of half the picture
  Pixels& pixels;

  float texel() const { return 2 * half / kShadowSide; }
  float step(Vec3) const { return texel(); }
  Vec3 seen(Vec3 at) const {
    Vec3 to = at - middle;
    return {(glm::dot(to, right) / half + 1) * kShadowSide / 2,
            (glm::dot(to, up) / half + 1) * kShadowSide / 2, kFar - glm::dot(to, way)};
  }
  void add(Vec3 at, float area, Vec3, Facing, float) const {
    Vec3 to = seen(at);
    pixels.put(to.x, to.y, 0.5f * std::sqrt(area) / texel(), to.z, 0);
  }
  /// Whether something is nearer to the sun. What is so by little may be the surface itself, which light that
  /// comes along it sees in steps: then the pixels round it must be nearer as well, which those farther along
  /// the surface are not.
  bool shaded(Vec3 at) const {
    constexpr float kRoom = 2.5f, kSurely = 40;  // texels
    constexpr int kRound = 2;                    // of which one is what bits are seen off their places
    Vec3 to = seen(at);
    int x = static_cast<int>(std::floor(to.x)), y = static_cast<int>(std::floor(to.y));
    if (!nearer(x, y, to.z - kRoom * texel())) return false;
    if (nearer(x, y, to.z - kSurely * texel())) return true;
    for (int row = -kRound; row <= kRound; ++row)
      for (int column = -kRound; column <= kRound; ++column)
        if (!nearer(x + column, y + row, to.z - kRoom * texel())) return false;
    return true;
  }

 private:
  bool nearer(int x, int y, float depth) const {
    bool within = x >= 0 && y >= 0 && x < kShadowSide && y < kShadowSide;
    return within && !pixels.empty(x, y) && pixels.depth(x, y) < depth;
  }
};

/// A ball of triangles, for the room that a copy takes.
Surface ball() {
  Surface s;
  constexpr int kRows = 6, kColumns = 10;
  for (int row = 0; row <= kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      double down = kPi * row / kRows, turn = 2 * kPi * column / kColumns;
      s.position.push_back(
          Vec3(std::sin(down) * std::cos(turn), std::cos(down), std::sin(down) * std::sin(turn)));
    }
  auto at = [](int row, int column) {
    return static_cast<std::uint32_t>(row * kColumns + column % kColumns);
  };
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      s.triangle.push_back({at(row, column), at(row, column + 1), at(row + 1, column)});
      s.triangle.push_back({at(row + 1, column), at(row, column + 1), at(row + 1, column + 1)});
    }
  return s;
}

Vec3 color_of(const Look& look) {
  if (look.leaves) return mean(look.leaves->colors);
  return look.branches.plant() ? Vec3(0.10f, 0.16f, 0.05f) : Vec3(0.25f, 0.25f, 0.23f);
}

/// The land's stones and all copies, in bits.
template <class Sink>
void sample_others(const Sink& sink, const Scene& scene, double time) {
  SurfelSampler<Sink> to{sink};
  to.strewn(scene.ground->strewn());
  const Surface round = ball();
  for (const CopySet& set : scene.copy_sets) {
    Vec3 color = color_of(set.appearance.look);
    auto wide = static_cast<float>(set.organism.sown->where.radius),
         tall = std::clamp(static_cast<float>(set.tallest()), 0.3f * wide, 9 * wide);
    float bare = tall > 3 * wide ? 0.3f * tall : 0;  // of a trunk
    Surface trunk;
    for (float turn : {0.0f, 2.1f, 4.2f})
      for (float up : {0.0f, bare})
        trunk.position.push_back(Vec3(0.012f * tall * std::cos(turn), up, 0.012f * tall * std::sin(turn)));
    trunk.triangle = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}, {4, 5, 0}, {5, 0, 1}};
    for (std::size_t i = 0; i < set.copies.size(); ++i) {
      if (!set.copies.there(i, time)) continue;
      Vec3 foot = set.copies.foot[i], scale = set.copies.scale_at(i, time);
      Quat turn = set.copies.turn_at(i, time);
      to.surface(round, color, true, foot + turn * Vec3(0, scale.y * 0.5f * (tall + bare), 0), turn,
                 scale * Vec3(wide, 0.5f * (tall - bare), wide));
      if (bare > 0) to.surface(trunk, set.appearance.look.branches.albedo(), true, foot, turn, scale);
    }
  }
}

/// Draws a mesh that begins under the camera: its depth at each pixel.
class FloorDepth {
 public:
  FloorDepth(const Surface& surface, const Lens& lens, int width, int height)
      : lens_(lens), width_(width), height_(height) {
    depth_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                  std::numeric_limits<float>::infinity());
    for (const auto& t : surface.triangle) {
      std::array<Vec3, 3> corner;
      for (std::size_t c = 0; c < 3; ++c) {
        Vec3 to = surface.position[t[c]] - lens.at;
        corner[c] = {glm::dot(to, lens.right), glm::dot(to, lens.up), glm::dot(to, lens.toward)};
      }
      clip(corner);
    }
  }

  /// Beyond the mesh the land is flat.
  float depth(int x, int y, Vec3 ray) const {
    float there = depth_[static_cast<std::size_t>(y * width_ + x)];
    float flat = ray.y < 0 && lens_.at.y > 0 ? -lens_.at.y / ray.y : std::numeric_limits<float>::infinity();
    return std::isfinite(there) || flat > kFar ? there : flat;
  }

 private:
  void clip(const std::array<Vec3, 3>& corner) {
    std::array<Vec3, 4> kept;
    std::size_t count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 a = corner[c], b = corner[(c + 1) % 3];
      if (a.z >= kNear) kept[count++] = a;
      if ((a.z < kNear) != (b.z < kNear)) kept[count++] = glm::mix(a, b, (kNear - a.z) / (b.z - a.z));
    }
    for (std::size_t c = 2; c < count; ++c) fill(kept[0], kept[c - 1], kept[c]);
  }

  void fill(Vec3 a, Vec3 b, Vec3 c) {
    // A depth's inverse is linear on the picture.
    auto seen = [&](Vec3 p) {
      return Vec3(0.5f * (1 + p.x / (lens_.wide * p.z)) * static_cast<float>(width_),
                  0.5f * (1 - p.y / (lens_.high * p.z)) * static_cast<float>(height_), 1 / p.z);
    };
    a = seen(a), b = seen(b), c = seen(c);
    float twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (!(std::abs(twice) > 1e-9f)) return;
    auto within = [](float x, int most) {
      return static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(most)));
    };
    for (int y = within(std::min({a.y, b.y, c.y}), height_);
         y < within(std::max({a.y, b.y, c.y}) + 1, height_); ++y)
      for (int x = within(std::min({a.x, b.x, c.x}), width_);
           x < within(std::max({a.x, b.x, c.x}) + 1, width_); ++x) {
        Vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        float of_b = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / twice,
              of_c = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / twice;
        if (of_b < -1e-3f || of_c < -1e-3f || of_b + of_c > 1.001f) continue;
        float& depth = depth_[static_cast<std::size_t>(y * width_ + x)];
        depth = std::min(depth, 1 / (a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z)));
      }
  }

  const Lens& lens_;
  int width_, height_;
  std::vector<float> depth_;
};

/// The sun's picture takes in what stands.
ToSun sun_over(const Scene& scene, Vec3 toward, Pixels& pixels) {
  Bounds box;
  for (const Specimen& s : scene.specimens) {
    box.extend(bounds_of(s.model));
    for (const Vec3& at : fallen_nodes(s)) box.extend(at);
  }
  Vec3 eye = scene.setup.camera.location.at(0);
  for (const CopySet& set : scene.copy_sets)
    for (const Vec3& p : set.copies.foot)
      if (glm::distance(p, eye) < 80) box.extend(p), box.extend(p + Vec3(0, set.tallest(), 0));
  if (box.empty()) box = {Vec3(-1), Vec3(1)};
  ToSun sun{{}, {}, toward, box.middle(), 0.5f * glm::length(box.size()) + 0.01f, pixels};
  sun.right = glm::normalize(glm::cross(reference_axis(toward), toward));
  sun.up = glm::cross(toward, sun.right);
  return sun;
}

}  // namespace

Raster quick_look(const Scene& scene, double time) { return quick_look(scene, time, scene.film.size); }

Raster quick_look(const Scene& scene, double time, std::array<int, 2> size) {
  auto [width, height] = size;
  Daylight light = daylight_of(setup_at(scene.setup, time));
  Lens lens = lens_at(scene.setup.camera, time, static_cast<double>(height) / width);
  Pixels pixels(width, height), from_sun(kShadowSide, kShadowSide);
  ToSun sun = sun_over(scene, light.sun, from_sun);
  ToPicture picture_sink{lens, pixels};
  // No shadow is finer than this share of a pixel: nodes may span much less than the animals that they bear.
  constexpr float kFinest = 0.25f;
  sun.half =
      std::max(sun.half, kFinest * picture_sink.pixel(glm::distance(sun.middle, lens.at)) * kShadowSide / 2);
  for (const Specimen& s : scene.specimens) {
    auto now = developed(s, time);
    if (!now) continue;
    DrawList drawn(**now, time);
    sample_surfels(sun, drawn);
    sample_surfels(picture_sink, drawn);
  }
  sample_others(sun, scene, time);
  sample_others(picture_sink, scene, time);
  if (scene.far) SurfelSampler<ToPicture>{picture_sink}.strewn(strewn_far(*scene.far));

  FloorDepth floor(scene.ground->floor(), lens, width, height);
  Raster picture(width, height, 3);
  Vec3 ground = linear(light.ground), shade = 0.45f * linear(light.zenith) + 0.12f;
  Vec3 sunny = shade + 0.9f * glm::min(light.sunlight / light.brightest, Vec3(1));
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      float across = 2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1,
            up = 1 - 2 * (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
      Vec3 ray = lens.toward + across * lens.wide * lens.right + up * lens.high * lens.up;  // a metre deep
      Vec3 color, albedo;
      float depth = floor.depth(x, y, ray);
      bool thing = !pixels.empty(x, y) && pixels.depth(x, y) < depth + 0.5f * sun.texel();
      if (thing)
        depth = pixels.depth(x, y), albedo = unpacked(pixels.color(x, y)), albedo *= albedo;
      else
        albedo = ground;
      if (std::isfinite(depth)) {
        bool shaded = light.sun.y <= 0 || sun.shaded(lens.at + depth * ray);
        color = albedo * (shaded ? shade : sunny);
        if (light.fade > 0)
          color = glm::mix(light.fog, color, std::exp(-depth / static_cast<float>(light.fade)));
      } else {
        color = backdrop_at(light, glm::normalize(ray).y);
      }
      for (int c = 0; c < 3; ++c)
        picture.data[picture.index(x, y, c)] = to_byte(encoded(std::clamp(color[c], 0.0f, 1.0f)));
    }
  });
  return picture;
}

}  // namespace frond
