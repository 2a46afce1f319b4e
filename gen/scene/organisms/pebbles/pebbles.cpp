#include "organisms/pebbles/pebbles.h"

#include <cmath>

#include "land/scatter.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr double kMostTriangles = 1e8;  // of all shapes

/// Errors for a shape without an inside, and for ranges with minimum above maximum.
Errors check_pebbles(const PebblesParams& params) {
  Errors errors = check_rock(params.shape);
  // A shape has about so many triangles where its finest cells are all over.
  double triangles = params.shapes * 8 * std::pow(4.0, params.shape.cells.depth);
  if (triangles > kMostTriangles)
    errors.push_back(error_at("/shapes",
                              "so many shapes of that depth may have {:.2g} triangles; expected {:.2g} at "
                              "most, by fewer shapes or a smaller depth",
                              triangles, kMostTriangles));
  if (params.least_size > params.most_size) errors.push_back({"", "least_size is above most_size"});
  return errors;
}

}  // namespace

PebblesParams::PebblesParams() {
  shape.cells = {5, 0.0008};
  shape.weathering = {.facets = 5, .facet_depth = 0.22, .edge = 0.8, .roughness = 0.2, .underside = 0.05};
  stone.scale = 0.03;
}

Result<Model> build_pebbles(const PebblesParams& params, Seed seed) {
  if (Errors errors = check_pebbles(params); !errors.empty()) return errors;
  constexpr float kPebbleRoom = 0.46f;                 // radius that one takes, of its longest side
  constexpr double kLean = 0.2;                        // radians, to either side
  constexpr double kFlattest = 0.75, kHighest = 1.05;  // of the height of its shape
  Model model;
  Solids& solids = model.solids;
  std::vector<float> height;
  double middle = (params.least_size + params.most_size) / 2;
  for (int i = 0; i < params.shapes; ++i) {
    Seed own = seed.child("shape", static_cast<std::uint64_t>(i));
    RockShape shape = params.shape;
    shape.size = middle;  // they are sized as they are laid
    Solid solid{rock_surface(shape, own), material_of(params.stone, own), {}};
    if (solid.surface.triangle.empty()) return hollow_rock(shape.form);
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
    auto spots =
        scatter(Vec2(0), params.inner, params.radius, kPebbleRoom * size, 1, taken, own.child("spot"));
    if (spots.empty()) continue;
    auto which =
        static_cast<std::uint16_t>(own.child("which").bits() % static_cast<std::uint64_t>(params.shapes));
    Quat turn = glm::angleAxis(static_cast<float>(own.child("turn").range(0, 2 * kPi)), Vec3(0, 1, 0));
    Quat lean = glm::angleAxis(static_cast<float>(own.child("lean").range(-kLean, kLean)), Vec3(1, 0, 0));
    float factor = size / static_cast<float>(middle);
    float sunk = static_cast<float>(params.buried) * height[which] * factor;
    Vec3 scale = factor * Vec3(1, own.child("flat").range(kFlattest, kHighest), 1);
    solids.place(which, Vec3(spots[0].at.x, -sunk, spots[0].at.y), turn * lean, scale);
  }
  return model;
}

void describe(Properties& v, PebblesParams& p) {
  describe_shape(v, p.shape);
  v.object("stone", p.stone, "The surface of the stones");
  v.integer("shapes", p.shapes, {.min = 1, .max = 1000}, "How many different shapes there are");
  v.integer("number", p.number, {.min = 1, .max = 20000}, "How many stones lie there, if there is room");
  v.number("radius", p.radius, metres(0.01, 100), "Radius of the field of stones");
  v.number("inner", p.inner, metres(0, 100), "Radius round the middle of the field that stays free");
  v.number("least_size", p.least_size, metres(0.001, 100), "Longest side of the smallest stone");
  v.number("most_size", p.most_size, metres(0.001, 100), "Longest side of the largest stone");
  v.number("buried", p.buried, kShare, "Share of a stone's height that is in the ground");
}

namespace {

class PebblesGrower final : public Described<PebblesParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {
      "number",          "radius",     "inner",      "least_size", "most_size", "shapes", "weathering/facets",
      "weathering/edge", "stone/kind", "stone/moss", "buried"};

  Review review() const override {
    Errors faults = check_pebbles(params);
    return {faults.empty() ? check_stone(params.stone) : faults};
  }
  Appearance appearance() const override { return stone_appearance(params.stone); }
  GrowerTraits traits() const override { return {.stands_on_rock = false}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    return SizeEstimate{.triangles = params.shapes * estimate_triangles(params.shape),
                        .blocks = static_cast<double>(params.number)};
  }
  Result<Model> grow_alone(Seed seed) const override { return build_pebbles(params, seed); }
};

}  // namespace

Kind<Organism> pebbles_kind() {
  return make_grower<PebblesGrower>("pebbles", "Many small rocks that lie about");
}

}  // namespace frond
