#include "organisms/stone_look.h"

#include <algorithm>
#include <cmath>

#include "appearance/mask_drawing.h"
#include "images/describe_mask.h"

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

constexpr Choice<Falloff> kFalloffs[] = {
    {"gaussian", Falloff::gaussian, "exp(-r d^2)"},
    {"soft", Falloff::soft, "1 - 4 d^6/9r^6 + 17 d^4/9r^4 - 22 d^2/9r^2"},
    {"cubic", Falloff::cubic, "(1 - d^2/r^2)^3"}};

constexpr Choice<RockForm> kForms[] = {
    {"blobs", RockForm::blobs, "blobs, broken and weathered"},
    {"framework", RockForm::framework,
     "a reef framework: dead colonies that have grown on one another, bored and eroded; for stone of the "
     "kind reef"},
    {"rubble", RockForm::rubble, "a worn fragment of a branched coral, as it lies in rubble"}};

constexpr Choice<StoneKind> kStoneKinds[] = {
    {"granite", StoneKind::granite, "speckled and massive"},
    {"limestone", StoneKind::limestone, "pale, banded and pitted"},
    {"basalt", StoneKind::basalt, "dark, fine and cracked"},
    {"reef", StoneKind::reef,
     "limestone under water: coralline crust, and with `moss` turf of algae on what faces upward"}};

Color brighter(Color c, double factor) {
  auto channel = [&](float x) { return std::clamp(x * static_cast<float>(factor), 0.0f, 1.0f); };
  return {channel(c.red), channel(c.green), channel(c.blue)};
}

}  // namespace

Material material_of(const StoneLook& look, Seed seed) {
  const KindRow& row = *std::ranges::find(kKinds, look.kind, &KindRow::kind);
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

Error hollow_rock(RockForm form) {
  if (form == RockForm::blobs)
    return {"", "these blobs have no inside; a lower level, or more and larger blobs?"};
  return {"/tolerance", "leaves nothing of such a form; expected a smaller one"};
}

float height_of(const Surface& surface) {
  float high = 0;
  for (const Vec3& p : surface.position) high = std::max(high, p.y);
  return high;
}

Errors check_rock(const RockShape& shape) {
  if (shape.form != RockForm::blobs) return {};
  double count = shape.own.empty() ? shape.chance.count : static_cast<double>(shape.own.size());
  if (count <= shape.level) return {hollow_rock(shape.form)};
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

void describe(Properties& v, Blob& b) {
  v.vector("radius", b.radius, {.min = 0.01, .max = 100}, "Radii of the ellipsoid along x, y and z");
  v.vector("center", b.center, {.min = -1000, .max = 1000}, "Middle of the ellipsoid, measured in its radii");
}

void describe(Properties& v, Weathering& w) {
  v.integer("facets", w.facets, {.min = 0, .max = 100},
            "Number of planes along which pieces have broken off");
  v.number("facet_depth", w.facet_depth, {.min = 0, .max = 0.9},
           "How much has broken off, as a share of the size");
  v.number("edge", w.edge, kShare, "How round the edges between facets are: 0 sharp, 1 worn");
  v.number("roughness", w.roughness, kShare, "How strong lumps, dents and grain are");
  v.number("strata", w.strata, kShare, "How far soft layers lie back behind hard ones; 0 shows no layers");
  v.number("layer", w.layer, {.min = 0.01, .max = 1},
           "Thickness of a layer, as a share of the size. Needs strata above 0");
  v.angle("dip", w.dip, {.min = 0, .max = 90},
          "Angle of the layers from the horizontal. Needs strata above 0");
  v.number("underside", w.underside, {.min = 0, .max = 0.9},
           "Share of the height below which the rock is cut flat");
}

void describe(Properties& v, Framework& f) {
  v.number("height", f.height, {.min = 0.2, .max = 1}, "Height of a framework, as a share of its size");
  v.integer("colonies", f.colonies, {.min = 0, .max = 2000},
            "Number of dead colonies that a framework is built of, the largest first");
  v.number("plates", f.plates, {.min = 0, .max = 1},
           "Share of them that are plates: ledges on steep sides and tables on level tops");
  v.number("branches", f.branches, {.min = 0, .max = 1},
           "Share of them that are stubs of branches; all others are domes");
  v.number("boring", f.boring, {.min = 0, .max = 1}, "How many caves, holes and pits there are");
  v.number("erosion", f.erosion, {.min = 0, .max = 1}, "How strong lumps and knobs are");
}

void describe(Properties& v, StoneLook& s) {
  v.aspect(Aspect::look);
  v.choice("kind", s.kind, kStoneKinds, "What stone it is");
  v.color("color", s.color, "Colour of the stone; without it that of its kind");
  v.color("second", s.second, "Colour of grains, bands or cracks; without it that of its kind");
  v.number("scale", s.scale, metres(0.001, 100), "Size of the pattern in the stone");
  v.number("relief", s.relief, {.min = 0, .max = 3}, "Depth of grain and cracks");
  v.number("moss", s.moss, kShare, "How much moss and lichen grow on what faces upward");
  v.object("moss_map", s.moss_map,
           "A picture that scales the moss, projected onto the stone in the world, with an area");
  v.number("variation", s.variation, {.min = 0, .max = 0.9},
           "How much single stones differ in brightness, as a share");
}

void describe_shape(Properties& v, RockShape& s) {
  v.choice("form", s.form, kForms, "What it is made as. Only blobs have weathering");
  v.object("framework", s.framework, "How a framework is built. Of rubble only erosion counts");
  v.list("ellipsoids", s.own, "The blobs that it is made of; without them random ones are taken");
  v.integer("blobs", s.chance.count, {.min = 1, .max = 200}, "Number of random blobs");
  v.number("least_radius", s.chance.least_radius, {.min = 0.01, .max = 100},
           "Least radius of a random blob, along each axis");
  v.number("most_radius", s.chance.most_radius, {.min = 0.01, .max = 100},
           "Greatest radius of a random blob, along each axis");
  v.choice("field", s.falloff, kFalloffs,
           "How the field of a blob falls with the distance d from its middle, r being its radius");
  v.number("level", s.level, {.min = 0.01, .max = 100},
           "Value of the summed fields at the surface; a higher one makes a thinner rock");
  v.integer("depth", s.cells.depth, {.min = 3, .max = 8},
            "Depth of the octree: the finest cells are 1/2^depth of the size");
  v.number("tolerance", s.cells.tolerance, {.min = 0, .max = 0.1},
           "Share of the size by which flat places may be off; 0 takes the finest cells all over");
  v.boolean("lying", s.lying, "Whether it lies on a broad side, its shortest axis upright");
  v.object("weathering", s.weathering, "What time has done to it");
}

}  // namespace frond
