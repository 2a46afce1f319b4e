#include "export/portrait.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/linear.h"

namespace frond {

namespace {

constexpr int kOpaque = 128;  // of 255: less is open

/// Samples of a picture before they become pixels.
struct Samples {
  int wide, high;
  std::vector<float> depth;
  std::vector<Vec3> light, normal;
  std::vector<char> leaf;

  Samples(int w, int h) : wide(w), high(h) {
    auto count = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
    depth.assign(count, -1e30f), light.assign(count, Vec3(0)), normal.assign(count, Vec3(0));
    leaf.assign(count, 0);
  }
};

float cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

int around(float share, int size) {
  int at = static_cast<int>(std::floor((share - std::floor(share)) * static_cast<float>(size)));
  return std::clamp(at, 0, size - 1);
}

/// The linear light of each value of a byte.
const std::array<float, 256>& lights() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = static_cast<float>(linear(static_cast<double>(i) / 255));
    return made;
  }();
  return table;
}

/// What is drawn of one part.
struct Worn {
  const ExportMaterial& material;
  const Raster* picture;
  Vec3 factor;

  /// The light at a place, or nothing where it is open.
  bool at(Vec2 uv, Vec3& light) const {
    light = factor;
    if (!picture) return true;
    int x = around(uv.x, picture->width), y = around(1 - uv.y, picture->height);
    if (material.cutout && picture->channels == 4 && picture->at(x, y, 3) < kOpaque) return false;
    for (int c = 0; c < 3; ++c) light[c] *= lights()[picture->at(x, y, picture->channels < 3 ? 0 : c)];
    return true;
  }
};

/// A triangle as the view has it: places in samples, depth toward the eye.
void draw_triangle(Samples& to, const ExportPart& part, const std::array<std::uint32_t, 3>& t,
                   const Worn& worn, const PortraitView& view, Vec3 toward) {
  const Surface& s = part.surface;
  Vec2 unit(static_cast<float>(to.wide) / (view.high.x - view.low.x),
            static_cast<float>(to.high) / (view.high.y - view.low.y));
  std::array<Vec2, 3> at;
  std::array<float, 3> depth{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = s.position[t[k]];
    at[k] =
        Vec2((glm::dot(p, view.right) - view.low.x) * unit.x, (view.high.y - glm::dot(p, view.up)) * unit.y);
    depth[k] = glm::dot(p, toward);
  }
  float all = cross(at[1] - at[0], at[2] - at[0]);
  if (std::abs(all) < 1e-9f) return;
  auto first = [](float low) {
    return std::max(0, static_cast<int>(std::ceil(std::max(low, -1e6f) - 0.5f)));
  };
  auto last = [](float high, int size) {
    return std::min(size - 1, static_cast<int>(std::floor(std::min(high, 1e6f) - 0.5f)));
  };
  int x0 = first(std::min({at[0].x, at[1].x, at[2].x})),
      x1 = last(std::max({at[0].x, at[1].x, at[2].x}), to.wide);
  int y0 = first(std::min({at[0].y, at[1].y, at[2].y})),
      y1 = last(std::max({at[0].y, at[1].y, at[2].y}), to.high);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      Vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      float a = cross(at[1] - p, at[2] - p) / all, b = cross(at[2] - p, at[0] - p) / all, c = 1 - a - b;
      if (a < 0 || b < 0 || c < 0) continue;
      float z = a * depth[0] + b * depth[1] + c * depth[2];
      auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(to.wide) + static_cast<std::size_t>(x);
      if (z <= to.depth[i]) continue;
      Vec3 light;
      Vec2 uv = s.uv.empty() ? Vec2(0) : a * s.uv[t[0]] + b * s.uv[t[1]] + c * s.uv[t[2]];
      if (!worn.at(uv, light)) continue;
      if (!part.tint.empty())
        for (int channel = 0; channel < 3; ++channel) {
          auto of = [&](std::size_t k) {
            return static_cast<float>(part.tint[t[k]][static_cast<std::size_t>(channel)]);
          };
          light[channel] *= (a * of(0) + b * of(1) + c * of(2)) / 255;
        }
      Vec3 n = a * s.normal[t[0]] + b * s.normal[t[1]] + c * s.normal[t[2]];
      n = Vec3(glm::dot(n, view.right), glm::dot(n, view.up), glm::dot(n, toward));
      if (n.z < 0 && worn.material.leaf) n = -n;
      to.depth[i] = z, to.light[i] = light, to.normal[i] = n, to.leaf[i] = worn.material.leaf;
    }
}

}  // namespace

double Portrait::covered() const {
  return std::accumulate(cover.begin(), cover.end(), 0.0) /
         std::max<double>(1, static_cast<double>(cover.size()));
}

Result<const Raster*> Painter::picture(std::size_t index) {
  auto [at, fresh] = pictures_.try_emplace(index);
  if (fresh) {
    Result<Raster> read = read_png(scene_.pictures[index].png);
    if (!read) return read.errors();
    at->second = std::move(*read);
  }
  return &at->second;
}

Result<Portrait> Painter::portrait(std::span<const Sitter> sitters, const PortraitView& view) {
  Samples samples(view.wide * view.fine, view.high_pixels * view.fine);
  Vec3 toward = glm::cross(view.right, view.up);
  for (const Sitter& sitter : sitters) {
    const ExportMaterial& material = scene_.materials[sitter.part->material];
    Worn worn{material, nullptr, linear(material.color)};
    if (material.colors != kNoPicture && !sitter.part->surface.uv.empty()) {
      Result<const Raster*> worn_picture = picture(material.colors);
      if (!worn_picture) return worn_picture.errors();
      worn.picture = *worn_picture, worn.factor = linear(material.factor);
    }
    const auto& all = sitter.part->surface.triangle;
    if (sitter.triangles.empty())
      for (const auto& t : all) draw_triangle(samples, *sitter.part, t, worn, view, toward);
    for (std::uint32_t t : sitter.triangles) draw_triangle(samples, *sitter.part, all[t], worn, view, toward);
  }
  Portrait made{view.wide, view.high_pixels, {}, {}, {}, {}};
  auto each = static_cast<float>(view.fine * view.fine);
  for (int y = 0; y < made.high; ++y)
    for (int x = 0; x < made.wide; ++x) {
      float count = 0, leaves = 0;
      Vec3 light(0), normal(0);
      for (int j = 0; j < view.fine; ++j)
        for (int k = 0; k < view.fine; ++k) {
          auto i = static_cast<std::size_t>(y * view.fine + j) * static_cast<std::size_t>(samples.wide) +
                   static_cast<std::size_t>(x * view.fine + k);
          if (samples.depth[i] < -1e29f) continue;
          ++count, leaves += samples.leaf[i] != 0, light += samples.light[i], normal += samples.normal[i];
        }
      made.cover.push_back(count / each), made.leaves.push_back(leaves / each);
      made.light.push_back(count > 0 ? light / count : light);
      made.normal.push_back(glm::length(normal) > 1e-6f ? glm::normalize(normal) : Vec3(0, 0, 1));
    }
  return made;
}

Result<double> silhouettes(Painter& painter, std::span<const Sitter> sitters, const Bounds& box) {
  constexpr int kPixels = 240;
  double sum = 0;
  for (int k = 0; k < 8; ++k) {
    PortraitView view = side_view(box, k * kPi / 4, kPixels);
    view.fine = 2;
    Result<Portrait> portrait = painter.portrait(sitters, view);
    if (!portrait) return portrait.errors();
    Vec2 size = view.high - view.low;
    sum += portrait->covered() * static_cast<double>(size.x * size.y);
  }
  return sum;
}

PortraitView side_view(const Bounds& box, double turn, int pixels) {
  PortraitView view;
  view.right = Vec3(std::cos(turn), 0, std::sin(turn));
  view.low = Vec2(1e30f), view.high = Vec2(-1e30f);
  for (int k = 0; k < 8; ++k) {
    Vec2 at(glm::dot(box.corner(k), view.right), box.corner(k).y);
    view.low = glm::min(view.low, at), view.high = glm::max(view.high, at);
  }
  Vec2 size = view.high - view.low;
  float longest = std::max({size.x, size.y, 1e-6f});
  auto pixels_of = [&](float length) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(pixels) * length / longest)));
  };
  view.wide = pixels_of(size.x), view.high_pixels = pixels_of(size.y);
  return view;
}

}  // namespace frond
