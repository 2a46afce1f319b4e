#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "export/parts.h"
#include "export/portrait.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr int kViews = 3, kWholeViews = 4;             // of a bough, of a whole plant with its top
constexpr float kTall = 1.2f;                          // times its width: a plant that needs no top
constexpr float kLeast = 0.75;                         // of its width, that a card of a whole plant keeps
constexpr std::array<double, 2> kFit = {0.85, 1.05};   // by which leaves are scaled, in one of two steps
constexpr std::array<double, 2> kShares = {0.2, 1.5};  // of what portraits cover, that cards may show

/// What one set of pictures shows.
struct Bough {
  std::vector<Sitter> sitters;
  Bounds box;
  Vec3 middle{0};  // where the cards cross
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
      for (std::uint32_t corner : s.triangle[i]) bough.box.extend(s.position[corner]);
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
  for (const Leaf& leaf : leaves) box.extend(leaf.middle);
  Vec3 size = box.size();
  int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int half = count / 2;
  auto at = leaves.size() * static_cast<std::size_t>(half) / static_cast<std::size_t>(count);
  std::ranges::stable_sort(leaves, {}, [&](const Leaf& leaf) { return leaf.middle[axis]; });
  part_into(parts, leaves.first(at), half, boughs);
  part_into(parts, leaves.subspan(at), count - half, boughs);
}

/// The whole of some parts.
Bough whole_of(const std::vector<const ExportPart*>& parts) {
  Bough bough;
  for (const ExportPart* part : parts) {
    bough.sitters.push_back({part});
    for (const Vec3& p : part->surface.position) bough.box.extend(p);
  }
  bough.middle = bough.box.middle();
  return bough;
}

/// A card, and the view that its picture shows.
struct Side {
  PortraitView view;
  Vec3 low, across, upward;  // its corner and its edges
  float scale = 1;           // of its width, to keep in the box
};

/// How far it is from a place to the wall of a box.
float way_out(const Bounds& box, Vec3 from, Vec3 toward) {
  float way = std::numeric_limits<float>::max();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(toward[axis]) < 1e-6f) continue;
    float wall = toward[axis] > 0 ? box.high[axis] : box.low[axis];
    way = std::min(way, std::max(0.0f, (wall - from[axis]) / toward[axis]));
  }
  return way;
}

/// All of a bough as it is seen straight across two directions, on a card through its middle.
Side side_of(const Bough& bough, Vec3 right, Vec3 up, int pixels) {
  Side side{{right, up, Vec2(1e30f), Vec2(-1e30f), pixels, pixels}, {}, {}, {}};
  for (const Sitter& sitter : bough.sitters) {
    const Surface& s = sitter.part->surface;
    auto extend = [&](Vec3 p) {
      Vec2 at(glm::dot(p, right), glm::dot(p, up));
      side.view.low = glm::min(side.view.low, at), side.view.high = glm::max(side.view.high, at);
    };
    if (sitter.triangles.empty()) std::ranges::for_each(s.position, extend);
    for (std::uint32_t t : sitter.triangles)
      for (std::uint32_t corner : s.triangle[t]) extend(s.position[corner]);
  }
  side.view.high = glm::max(side.view.high, side.view.low + 1e-4f);
  Vec3 middle = bough.middle;
  float at = glm::dot(middle, right), before = at - side.view.low.x, after = side.view.high.x - at;
  if (before > 0) side.scale = std::min(side.scale, way_out(bough.box, middle, -right) / before);
  if (after > 0) side.scale = std::min(side.scale, way_out(bough.box, middle, right) / after);
  Vec3 foot = middle + up * (side.view.low.y - glm::dot(middle, up));
  side.low = foot - right * (before * side.scale);
  side.across = right * ((before + after) * side.scale);
  side.upward = up * (side.view.high.y - side.view.low.y);
  return side;
}

/// The front, the right side and the top of a bough.
std::vector<Side> sides_of(const Bough& bough, int pixels) {
  return {side_of(bough, {1, 0, 0}, {0, 1, 0}, pixels), side_of(bough, {0, 0, -1}, {0, 1, 0}, pixels),
          side_of(bough, {1, 0, 0}, {0, 0, -1}, pixels)};
}

/// Three sides of a whole plant, by as much apart as its box is long and wide, and the top where most of its
/// leaves are that lie. Of three sides as much is seen from everywhere round it, of two not.
std::vector<Side> whole_sides(Bough& whole, int pixels) {
  Vec3 size = glm::max(whole.box.size(), Vec3(1e-4f)), middle = whole.box.middle();
  auto upright = [&] {
    std::vector<Side> sides;
    for (int k = 0; k < 3; ++k) {
      auto turn = static_cast<float>(k * kPi / 3);
      Vec3 right = glm::normalize(Vec3(size.x * std::cos(turn), 0, size.z * std::sin(turn)));
      sides.push_back(side_of(whole, right, {0, 1, 0}, pixels));
    }
    return sides;
  };
  // They cross over the foot, so that there is one trunk, unless the plant leans far from there.
  whole.middle = glm::clamp(Vec3(0, middle.y, 0), whole.box.low, whole.box.high);
  std::vector<Side> sides = upright();
  if (std::ranges::min(sides, {}, &Side::scale).scale < kLeast) whole.middle = middle, sides = upright();
  if (size.y > kTall * std::max(size.x, size.z)) return sides;
  float sum = 0, height = 0;
  for (const Sitter& sitter : whole.sitters) {
    const Surface& s = sitter.part->surface;
    for (auto [a, b, c] : s.triangle) {
      float flat = std::abs(glm::cross(s.position[b] - s.position[a], s.position[c] - s.position[a]).y);
      sum += flat, height += flat * s.position[a].y;
    }
  }
  whole.middle = Vec3(middle.x, sum > 0 ? height / sum : middle.y, middle.z);
  sides.push_back(side_of(whole, {1, 0, 0}, {0, 0, -1}, pixels));
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

/// The share of the portraits with which cards have the silhouettes of what they show: from eight sides, as a
/// mean of all.
Result<double> fitting_share(Maker& maker, std::span<const Sitter> shown, const Bounds& box,
                             const ExportPart& cards, const ExportMaterial& material, PictureSheet& sheet) {
  Painter first(maker.exported);
  Result<double> wanted = silhouettes(first, shown, box);
  if (!wanted) return wanted.errors();
  ExportScene only;
  only.materials = {material};
  only.materials[0].colors = 0;
  Sitter card{&cards};
  double low = kShares[0], high = kShares[1];
  for (int step = 0; step < 7; ++step) {
    double share = (low + high) / 2;
    sheet.cut(share);
    Painter painter(only);
    painter.wear(0, sheet.colors());
    Result<double> covered = silhouettes(painter, {&card, 1}, box);
    if (!covered) return covered.errors();
    (*covered < *wanted ? low : high) = share;
  }
  return (low + high) / 2;
}

/// BranchVolume as cards with a material of their own.
Result<ExportPart> crossed(Maker& maker, std::vector<Bough>& boughs, int cell, bool whole,
                           const std::string& name) {
  PictureSheet sheet(static_cast<int>(boughs.size()) * (whole ? kWholeViews : kViews), cell);
  Painter painter(maker.exported);
  ExportPart made;
  std::vector<Sitter> shown;
  Bounds box;
  int number = 0;
  for (Bough& bough : boughs) {
    for (const Side& side : whole ? whole_sides(bough, sheet.inner()) : sides_of(bough, sheet.inner())) {
      Result<Portrait> portrait = painter.portrait(bough.sitters, side.view);
      if (!portrait) return portrait.errors();
      sheet.put(*portrait, number);
      add_card(made.surface, side, sheet.corner(number, false), sheet.corner(number, true));
      ++number;
    }
    shown.insert(shown.end(), bough.sitters.begin(), bough.sitters.end());
    box.extend(bough.box);
  }
  BakedPictures pictures;
  pictures.mean = sheet.fill();
  ExportMaterial material;
  material.factor = {1, 1, 1}, material.gloss = 0.1, material.leaf = material.cutout = true;
  Result<double> share = fitting_share(maker, shown, box, made, material, sheet);
  if (!share) return share.errors();
  sheet.cut(*share);
  Result<std::string> colors = png_text(sheet.colors()), normals = png_text(sheet.normals());
  if (!colors) return colors.errors();
  if (!normals) return normals.errors();
  pictures.colors = std::move(*colors), pictures.normals = std::move(*normals);
  made.material = maker.palette.shown(material, name, std::move(pictures));
  return made;
}

/// Larger leaves that are fewer hide less of each other: scales those of the coarser levels until they cover
/// as much as the first.
Errors fit_leaves(Maker& maker, std::size_t index) {
  ExportMesh& mesh = maker.exported.meshes[index];
  auto leaves_in = [&](std::vector<ExportPart>& parts) {
    std::vector<ExportPart*> leaves;
    for (ExportPart& part : parts)
      if (maker.exported.materials[part.material].leaf) leaves.push_back(&part);
    return leaves;
  };
  Painter painter(maker.exported);
  Bounds box;
  auto covered = [&](const std::vector<ExportPart*>& leaves) {
    std::vector<Sitter> sitters;
    for (ExportPart* part : leaves) sitters.push_back({part});
    return silhouettes(painter, sitters, box);
  };
  std::vector<ExportPart*> first = leaves_in(mesh.parts);
  if (first.empty() || mesh.coarser.empty()) return {};
  for (const ExportPart* part : first)
    for (const Vec3& at : part->surface.position) box.extend(at);
  Result<double> wanted = covered(first);
  if (!wanted) return wanted.errors();
  for (std::size_t level = 1; level <= mesh.coarser.size(); ++level) {
    if (std::ranges::any_of(maker.crossed, [&](const CrossedLevel& other) {
          return other.level == level && other.meshes[0] == index;
        }))
      continue;
    std::vector<ExportPart*> leaves = leaves_in(mesh.coarser[level - 1]);
    for (int step = 0; step < 2 && !leaves.empty(); ++step) {
      Result<double> now = covered(leaves);
      if (!now) return now.errors();
      double factor = std::clamp(std::sqrt(*wanted / std::max(*now, 1e-9)), kFit[0], kFit[1]);
      for (ExportPart* part : leaves) grow_pieces(part->surface, static_cast<float>(factor));
    }
  }
  return {};
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
        crossed(maker, boughs, whole ? maker.options.texture : bough_pixels(maker.options), whole,
                to.name + (whole ? "_whole" : "_boughs"));
    if (!made) return made.errors();
    to.set_level(level.level, {std::move(*made)});
  }
  for (std::size_t i = 0; maker.options.texture > 0 && i < maker.exported.meshes.size(); ++i)
    if (Errors errors = fit_leaves(maker, i); !errors.empty()) return errors;
  return {};
}

}  // namespace frond
