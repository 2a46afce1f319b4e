#include "organisms/stone_look.h"

#include <algorithm>
#include <cmath>

#include "appearance/mask_drawing.h"

namespace frond {

namespace {

struct KindRow {
  StoneKind kind;
  Matter matter;
  Color color, second;
  double gloss;
};

constexpr KindRow kKinds[] = {
    {StoneKind::granite, Matter::granite, {0.62f, 0.58f, 0.54f}, {0.27f, 0.26f, 0.26f}, 0.12},
    {StoneKind::limestone, Matter::karst, {0.74f, 0.69f, 0.58f}, {0.50f, 0.42f, 0.31f}, 0.03},
    {StoneKind::basalt, Matter::basalt, {0.30f, 0.30f, 0.31f}, {0.44f, 0.34f, 0.25f}, 0.10},
    {StoneKind::reef, Matter::reef, {0.56f, 0.52f, 0.44f}, {0.58f, 0.27f, 0.36f}, 0.05}};

Color brighter(Color c, double factor) {
  auto channel = [&](float x) { return std::clamp(x * static_cast<float>(factor), 0.0f, 1.0f); };
  return {channel(c.red), channel(c.green), channel(c.blue)};
}

}  // namespace

Material material_of(const StoneLook& look, Seed seed) {
  const KindRow& row = *std::find_if(std::begin(kKinds), std::end(kKinds),
                                     [&](const KindRow& r) { return r.kind == look.kind; });
  double light = 1 + look.variation * seed.child("brightness").range(-1, 1);
  Material material{row.matter,
                    brighter(look.color.value_or(row.color), light),
                    brighter(look.second.value_or(row.second), light),
                    look.scale,
                    look.relief,
                    look.moss,
                    row.gloss};
  if (!look.moss_map.empty()) material.moss_map = look.moss_map;
  return material;
}

Errors check_stone(const StoneLook& look) {
  if (look.moss_map.file.empty() || !look.moss_map.area.empty()) return {};
  return {{"/stone/moss_map", "has no area; expected the two corners in the world that its picture covers"}};
}

Appearance stone_appearance(const StoneLook& look) {
  Appearance appearance;
  if (!look.moss_map.empty()) appearance.look.pictures.push_back(mask_drawing(look.moss_map));
  return appearance;
}

Error hollow_rock() { return {"", "these blobs have no inside; a lower level, or more and larger blobs?"}; }

float height_of(const Surface& surface) {
  float high = 0;
  for (const Vec3& p : surface.position) high = std::max(high, p.y);
  return high;
}

Errors check_rock(const RockShape& shape) {
  double count = shape.own.empty() ? shape.chance.count : static_cast<double>(shape.own.size());
  if (count <= shape.level) return {hollow_rock()};
  if (shape.own.empty() && shape.chance.least_radius > shape.chance.most_radius)
    return {{"", "least_radius is above most_radius"}};
  return {};
}

double estimate_triangles(const RockShape& shape) {
  // Triangles at a tolerance in metres, and the power by which a finer one makes more of them.
  constexpr double kTriangles = 6e4, kAtTolerance = 0.0003, kFinerPower = 0.87;
  constexpr double kOneCellTriangles =
      6.6;  // where cells are not divided; each division makes 4 times as many
  double flat = kTriangles * std::pow(kAtTolerance / std::max(shape.cells.tolerance, 1e-9), kFinerPower);
  return std::min(flat, kOneCellTriangles * std::pow(4.0, shape.cells.depth));
}

}  // namespace frond
