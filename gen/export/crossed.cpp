#include "export/crossed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/linear.h"
#include "export/portrait.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr int kViews = 3;
constexpr int kMargin = 1;         // pixels round each picture, that the next one does not show in it
constexpr double kCrossed = 0.85;  // of what a bough's pictures cover: the others add to it between the sides
constexpr double kWhole = 0.79;    // the same of a whole plant

/// What one set of pictures shows.
struct Bough {
  std::vector<Sitter> sitters;
  Bounds box;
  Vec3 middle{0};  // where the pictures cross
};

/// A leaf, or another piece of a part.
struct Leaf {
  std::size_t part;
  std::vector<std::uint32_t> triangles;
  Vec3 middle{0};  // times area
  float area = 0;
};

std::vector<Leaf> leaves_of(const std::vector<ExportPart>& parts) {
  std::vector<Leaf> leaves;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Surface& s = parts[p].surface;
    Pieces pieces = pieces_of(s);
    std::size_t first = leaves.size();
    for (std::uint32_t k = 0; k < pieces.count; ++k) leaves.push_back({p, {}});
    for (std::uint32_t i = 0; i < s.triangle.size(); ++i) {
      auto [a, b, c] = s.triangle[i];
      Leaf& leaf = leaves[first + pieces.of[a]];
      float size =
          0.5f * glm::length(glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]));
      leaf.triangles.push_back(i), leaf.area += size;
      leaf.middle += (s.position[a] + s.position[b] + s.position[c]) * (size / 3);
    }
  }
  std::erase_if(leaves, [](const Leaf& leaf) { return leaf.area <= 0; });
  for (Leaf& leaf : leaves) leaf.middle /= leaf.area;
  return leaves;
}

Bough bough_of(const std::vector<ExportPart>& parts, std::span<const Leaf> leaves) {
  Bough bough;
  std::vector<Sitter> sitters;
  for (const ExportPart& part : parts) sitters.push_back({&part});
  float sum = 0;
  for (const Leaf& leaf : leaves) {
    const Surface& s = parts[leaf.part].surface;
    for (std::uint32_t i : leaf.triangles) {
      sitters[leaf.part].triangles.push_back(i);
      for (std::uint32_t corner : s.triangle[i]) bough.box.take(s.position[corner]);
    }
    bough.middle += leaf.middle * leaf.area, sum += leaf.area;
  }
  if (sum > 0) bough.middle /= sum;
  for (Sitter& sitter : sitters)
    if (!sitter.triangles.empty()) bough.sitters.push_back(std::move(sitter));
  return bough;
}

/// Parts leaves into so many boughs, along the longest side of the box that their middles fill.
void part_into(const std::vector<ExportPart>& parts, std::span<Leaf> leaves, int count,
               std::vector<Bough>& boughs) {
  if (leaves.empty()) return;
  if (count <= 1 || leaves.size() == 1) return boughs.push_back(bough_of(parts, leaves));
  Bounds box;
  for (const Leaf& leaf : leaves) box.take(leaf.middle);
  Vec3 size = box.size();
  int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int half = count / 2;
  auto at = leaves.size() * static_cast<std::size_t>(half) / static_cast<std::size_t>(count);
  std::ranges::stable_sort(leaves, {}, [&](const Leaf& leaf) { return leaf.middle[axis]; });
  part_into(parts, leaves.first(at), half, boughs);
  part_into(parts, leaves.subspan(at), count - half, boughs);
}

/// The whole of some parts; its pictures cross over the foot, so that there is one trunk.
Bough whole_of(const std::vector<const ExportPart*>& parts) {
  Bough bough;
  for (const ExportPart* part : parts) {
    bough.sitters.push_back({part});
    for (const Vec3& p : part->surface.position) bough.box.take(p);
  }
  bough.middle = glm::clamp(Vec3(0, bough.box.middle().y, 0), bough.box.low, bough.box.high);
  return bough;
}

/// The front, the right side and the top of a box, and the corners of the card that shows each, by shares of
/// the picture.
struct Side {
  PortraitView view;
  Vec3 low, across, upward;
};

std::array<Side, kViews> sides_of(const Bough& bough, int pixels) {
  const Bounds& box = bough.box;
  std::array<std::array<Vec3, 2>, kViews> axes = {
      {{Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, -1), Vec3(0, 1, 0)}, {Vec3(1, 0, 0), Vec3(0, 0, -1)}}};
  std::array<Side, kViews> sides;
  for (std::size_t k = 0; k < kViews; ++k) {
    auto [right, up] = axes[k];
    Side& side = sides[k];
    side.view = {right, up, Vec2(1e30f), Vec2(-1e30f), pixels, pixels};
    for (int c = 0; c < 8; ++c) {
      Vec2 at(glm::dot(box.corner(c), right), glm::dot(box.corner(c), up));
      side.view.low = glm::min(side.view.low, at), side.view.high = glm::max(side.view.high, at);
    }
    side.view.high = glm::max(side.view.high, side.view.low + 1e-4f);
    Vec3 toward = glm::cross(right, up);
    side.low = right * side.view.low.x + up * side.view.low.y + toward * glm::dot(bough.middle, toward);
    side.across = right * (side.view.high.x - side.view.low.x);
    side.upward = up * (side.view.high.y - side.view.low.y);
  }
  return sides;
}

void add_card(Surface& cards, const Side& side, Vec2 low, Vec2 high) {
  auto first = static_cast<std::uint32_t>(cards.position.size());
  Vec3 normal = glm::normalize(glm::cross(side.across, side.upward));
  for (Vec2 at : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
    cards.position.push_back(side.low + side.across * at.x + side.upward * at.y);
    cards.normal.push_back(normal);
    cards.uv.push_back(glm::mix(low, high, at));
  }
  cards.triangle.push_back({first, first + 1, first + 2});
  cards.triangle.push_back({first, first + 2, first + 3});
}

/// Opacity by which as large a share of a picture is opaque as is covered.
std::vector<std::uint8_t> opacity_of(const Portrait& portrait, double share) {
  std::vector<float> sorted = portrait.cover;
  std::ranges::sort(sorted, std::greater());
  auto kept = static_cast<std::size_t>(share * portrait.covered() * static_cast<double>(sorted.size()));
  float least = std::max(sorted[std::min(kept, sorted.size() - 1)], 1e-3f);
  std::vector<std::uint8_t> opacity;
  for (float cover : portrait.cover) opacity.push_back(to_byte(0.5 * static_cast<double>(cover / least)));
  return opacity;
}

/// Pictures side by side.
struct Sheet {
  int cell, columns;
  Raster colors, normals;
  std::vector<char> seen;  // of each pixel

  Sheet(int cells, int pixels) : cell(pixels) {
    columns = cells <= kViews ? cells : static_cast<int>(std::ceil(std::sqrt(cells)));
    int rows = (cells + columns - 1) / columns;
    colors = Raster(columns * cell, rows * cell, 4), normals = Raster(columns * cell, rows * cell, 3);
    seen.assign(colors.data.size() / 4, 0);
  }

  void put(const Portrait& portrait, const std::vector<std::uint8_t>& opacity, int number) {
    int left = number % columns * cell + kMargin, top = number / columns * cell + kMargin;
    for (int y = 0; y < portrait.high; ++y)
      for (int x = 0; x < portrait.wide; ++x) {
        auto from = static_cast<std::size_t>(y * portrait.wide + x);
        if (portrait.cover[from] <= 0) continue;
        Color color = srgb(glm::min(portrait.light[from], Vec3(1)));
        std::size_t at = colors.index(left + x, top + y), n = normals.index(left + x, top + y);
        colors.data[at] = to_byte(color.red), colors.data[at + 1] = to_byte(color.green);
        colors.data[at + 2] = to_byte(color.blue), colors.data[at + 3] = opacity[from];
        for (int c = 0; c < 3; ++c)
          normals.data[n + static_cast<std::size_t>(c)] = to_byte(0.5 + 0.5 * portrait.normal[from][c]);
        seen[at / 4] = 1;
      }
  }

  /// Corners on the sheet, v upward.
  Vec2 corner(int number, bool high) const {
    int x = number % columns * cell + (high ? cell - kMargin : kMargin);
    int y = number / columns * cell + (high ? kMargin : cell - kMargin);
    return {static_cast<float>(x) / static_cast<float>(colors.width),
            1 - static_cast<float>(y) / static_cast<float>(colors.height)};
  }

  /// What is open takes the colours of what is next to it, or edges would be seen dark; the mean of all.
  Color fill() {
    Vec3 sum(0);
    float count = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (seen[i]) {
        const std::uint8_t* p = &colors.data[4 * i];
        sum += linear(Color{p[0] / 255.0f, p[1] / 255.0f, p[2] / 255.0f}), ++count;
      }
    Color mean = srgb(sum / std::max(count, 1.0f));
    std::array<std::uint8_t, 3> plain{to_byte(mean.red), to_byte(mean.green), to_byte(mean.blue)};
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (!seen[i]) {
        std::size_t near = nearest(i);
        std::copy_n(near == i ? plain.data() : &colors.data[4 * near], 3, &colors.data[4 * i]);
        if (near == i)
          normals.data[3 * i] = normals.data[3 * i + 1] = 128, normals.data[3 * i + 2] = 255;
        else
          std::copy_n(&normals.data[3 * near], 3, &normals.data[3 * i]);
      }
    return mean;
  }

 private:
  /// A pixel that is seen within a few of it, or itself.
  std::size_t nearest(std::size_t i) const {
    constexpr int kFar = 3;
    int width = colors.width, x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    std::size_t best = i;
    int least = kFar * kFar + 1;
    for (int dy = -kFar; dy <= kFar; ++dy)
      for (int dx = -kFar; dx <= kFar; ++dx) {
        int u = x + dx, v = y + dy, far = dx * dx + dy * dy;
        if (u < 0 || v < 0 || u >= width || v >= colors.height || far >= least) continue;
        auto at = static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
        if (seen[at]) best = at, least = far;
      }
    return best;
  }
};

/// Boughs as cards with a material of their own.
Result<ExportPart> crossed(Maker& maker, const std::vector<Bough>& boughs, int cell, double share,
                           const std::string& name) {
  Sheet sheet(static_cast<int>(boughs.size()) * kViews, cell);
  Painter painter(maker.exported);
  ExportPart made;
  int number = 0;
  for (const Bough& bough : boughs)
    for (const Side& side : sides_of(bough, cell - 2 * kMargin)) {
      Result<Portrait> portrait = painter.portrait(bough.sitters, side.view);
      if (!portrait) return portrait.errors();
      sheet.put(*portrait, opacity_of(*portrait, share), number);
      add_card(made.surface, side, sheet.corner(number, false), sheet.corner(number, true));
      ++number;
    }
  BakedPictures pictures;
  pictures.mean = sheet.fill();
  Result<std::string> colors = png_text(sheet.colors), normals = png_text(sheet.normals);
  if (!colors) return colors.errors();
  if (!normals) return normals.errors();
  pictures.colors = std::move(*colors), pictures.normals = std::move(*normals);
  ExportMaterial material;
  material.factor = {1, 1, 1}, material.gloss = 0.1, material.leaf = material.cutout = true;
  made.material = maker.palette.shown(material, name, std::move(pictures));
  return made;
}

}  // namespace

Errors add_crossed_levels(Maker& maker) {
  for (const CrossedLevel& level : maker.crossed) {
    std::vector<ExportMesh>& meshes = maker.exported.meshes;
    ExportMesh& to = meshes[level.meshes[0]];
    std::vector<Bough> boughs;
    if (level.boughs > 0) {
      std::vector<Leaf> leaves = leaves_of(to.parts);
      part_into(to.parts, leaves, level.boughs, boughs);
    } else {
      std::vector<const ExportPart*> parts;
      for (std::size_t mesh : level.meshes)
        for (const ExportPart& part : meshes[mesh].parts) parts.push_back(&part);
      boughs.push_back(whole_of(parts));
    }
    bool whole = level.boughs == 0;
    Result<ExportPart> made =
        crossed(maker, boughs, whole ? maker.options.texture : bough_pixels(maker.options),
                whole ? kWhole : kCrossed, to.name + (whole ? "_whole" : "_boughs"));
    if (!made) return made.errors();
    to.set_level(level.level, {std::move(*made)});
  }
  return {};
}

}  // namespace frond
