#include "organisms/rock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/scatter.h"

namespace frond {

namespace {

struct KindRow {
  StoneKind kind;
  Matter matter;
  Color color, second;
  double gloss;
};

constexpr double kMostTriangles = 1e8;  // of all shapes of pebbles

constexpr KindRow kKinds[] = {
    {StoneKind::granite, Matter::granite, {0.62f, 0.58f, 0.54f}, {0.27f, 0.26f, 0.26f}, 0.12},
    {StoneKind::limestone, Matter::karst, {0.74f, 0.69f, 0.58f}, {0.50f, 0.42f, 0.31f}, 0.03},
    {StoneKind::basalt, Matter::basalt, {0.30f, 0.30f, 0.31f}, {0.44f, 0.34f, 0.25f}, 0.10}};

Color brighter(Color c, double factor) {
  auto channel = [&](float x) { return std::clamp(x * static_cast<float>(factor), 0.0f, 1.0f); };
  return {channel(c.red), channel(c.green), channel(c.blue)};
}

Material material_of(const StoneLook& look, Seed seed) {
  const KindRow& row = *std::find_if(std::begin(kKinds), std::end(kKinds),
                                     [&](const KindRow& r) { return r.kind == look.kind; });
  double light = 1 + look.variation * seed.child("brightness").range(-1, 1);
  return {row.matter,
          brighter(look.color.value_or(row.color), light),
          brighter(look.second.value_or(row.second), light),
          look.scale,
          look.relief,
          look.moss,
          row.gloss};
}

Error hollow() { return {"", "these blobs have no inside; a lower level, or more and larger blobs?"}; }

float height_of(const Surface& surface) {
  float high = 0;
  for (const Vec3& p : surface.position) high = std::max(high, p.y);
  return high;
}

}  // namespace

PebblesParams::PebblesParams() {
  shape.cells = {5, 0.0008};
  shape.weathering = {.facets = 5, .facet_depth = 0.22, .edge = 0.8, .roughness = 0.2, .underside = 0.05};
  stone.scale = 0.03;
}

Errors check_rock(const RockShape& shape) {
  double count = shape.own.empty() ? shape.chance.count : static_cast<double>(shape.own.size());
  if (count <= shape.level) return {hollow()};
  if (shape.own.empty() && shape.chance.least_radius > shape.chance.most_radius)
    return {{"", "least_radius is above most_radius"}};
  return {};
}

Errors check_pebbles(const PebblesParams& params) {
  Errors errors = check_rock(params.shape);
  // A shape has about so many triangles where its finest cells are all over.
  double triangles = params.shapes * 8 * std::pow(4.0, params.shape.cells.depth);
  if (triangles > kMostTriangles)
    errors.push_back(
        {"/shapes", fmt::format("so many shapes of that depth may have {:.2g} triangles; expected "
                                "{:.2g} at most, by fewer shapes or a smaller depth",
                                triangles, kMostTriangles)});
  if (params.least_size > params.most_size) errors.push_back({"", "least_size is above most_size"});
  return errors;
}

Result<Model> build_rock(const RockParams& params, Seed seed) {
  if (Errors errors = check_rock(params.shape); !errors.empty()) return errors;
  Seed form = seed.child("form");
  Solid solid;
  if (params.native) {
    Blobs blobs = rock_blobs(params.shape, form);
    solid.surface = bare_rock(params.shape, blobs);
    solid.native = native_rock(params.shape, blobs);
  } else {
    solid.surface = rock_surface(params.shape, form);
  }
  if (solid.surface.triangle.empty()) return hollow();
  solid.material = material_of(params.stone, seed);
  float sunk = static_cast<float>(params.buried) * height_of(solid.surface);
  Model model;
  model.solids.place(model.solids.add_shape(std::move(solid)), Vec3(0, -sunk, 0));
  return model;
}

Result<Model> build_pebbles(const PebblesParams& params, Seed seed) {
  if (Errors errors = check_pebbles(params); !errors.empty()) return errors;
  Model model;
  Solids& solids = model.solids;
  std::vector<float> height;
  double middle = (params.least_size + params.most_size) / 2;
  for (int i = 0; i < params.shapes; ++i) {
    Seed own = seed.child("shape", static_cast<std::uint64_t>(i));
    RockShape shape = params.shape;
    shape.size = middle;  // they are sized as they are laid
    Solid solid{rock_surface(shape, own), material_of(params.stone, own), {}};
    if (solid.surface.triangle.empty()) return hollow();
    height.push_back(height_of(solid.surface));
    solids.add_shape(std::move(solid));
  }
  solids.follow_ground = true;

  TakenSpots taken;
  for (int i = 0; i < params.number; ++i) {
    Seed own = seed.child("pebble", static_cast<std::uint64_t>(i));
    // The number falls with the square of the size, as that of broken stone does; the large ones come first.
    double share = (i + own.child("size").unit()) / params.number,
           ratio = params.least_size / params.most_size;
    float size =
        static_cast<float>(params.least_size / std::sqrt(ratio * ratio + (1 - ratio * ratio) * share));
    auto spots = scatter(Vec2(0), params.inner, params.radius, 0.46f * size, 1, taken, own.child("spot"));
    if (spots.empty()) continue;
    auto which =
        static_cast<std::uint16_t>(own.child("which").bits() % static_cast<std::uint64_t>(params.shapes));
    Quat turn = glm::angleAxis(static_cast<float>(own.child("turn").range(0, 2 * kPi)), Vec3(0, 1, 0));
    Quat lean = glm::angleAxis(static_cast<float>(own.child("lean").range(-0.2, 0.2)), Vec3(1, 0, 0));
    float factor = size / static_cast<float>(middle);
    float sunk = static_cast<float>(params.buried) * height[which] * factor;
    Vec3 scale = factor * Vec3(1, static_cast<float>(own.child("flat").range(0.75, 1.05)), 1);
    solids.place(which, Vec3(spots[0].at.x, -sunk, spots[0].at.y), turn * lean, scale);
  }
  return model;
}

}  // namespace frond
