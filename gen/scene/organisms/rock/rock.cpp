#include "organisms/rock/rock.h"

#include "organisms/kinds.h"

namespace frond {

namespace {

Errors check(const RockParams& params) {
  if (params.native && params.shape.form != RockForm::blobs)
    return {{"/native", "is for rocks of blobs; expected false, or the form blobs"}};
  return check_rock(params.shape);
}

}  // namespace

Result<Model> build_rock(const RockParams& params, Seed seed) {
  if (Errors errors = check(params); !errors.empty()) return errors;
  Seed form = seed.child("form");
  Solid solid;
  if (params.native) {
    Blobs blobs = rock_blobs(params.shape, form);
    solid.surface = bare_rock(params.shape, blobs);
    solid.native = native_rock(params.shape, blobs);
  } else {
    solid.surface = rock_surface(params.shape, form);
  }
  if (solid.surface.triangle.empty()) return hollow_rock(params.shape.form);
  solid.material = material_of(params.stone, seed);
  float sunk = static_cast<float>(params.buried) * height_of(solid.surface);
  Model model;
  model.solids.place(model.solids.add_shape(std::move(solid)), Vec3(0, -sunk, 0));
  return model;
}

void describe(Properties& v, RockParams& r) {
  v.number("size", r.shape.size, {.min = 0.001, .max = 1000, .unit = "m"},
           "Length of its longest side, before weathering");
  describe_shape(v, r.shape);
  v.object("stone", r.stone, "The surface of the stone");
  v.number("buried", r.buried, {.min = 0, .max = 1}, "Share of its height that is in the ground");
  v.boolean(
      "native", r.native,
      "Whether it is written as an isosurface of POV-Ray's own: the blobs alone, exact, without weathering");
}

namespace {

class RockGrower final : public Described<RockParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"size",
                                                  "lying",
                                                  "weathering/facets",
                                                  "weathering/facet_depth",
                                                  "weathering/edge",
                                                  "weathering/roughness",
                                                  "weathering/strata",
                                                  "stone/kind",
                                                  "stone/color",
                                                  "stone/moss",
                                                  "buried"};

  Review review() const override {
    Errors faults = check(params);
    return {faults.empty() ? check_stone(params.stone) : faults};
  }
  Appearance appearance() const override { return stone_appearance(params.stone); }
  std::shared_ptr<const Grower> coarse(double share) const override {
    static constexpr int kCoarseDepth = 5, kCoarsestDepth = 4;
    static constexpr double kCoarsest = 0.1, kCoarseTolerance = 0.004;  // share of detail; metres
    return changed(*this, [&](RockParams& p) {
      p.shape.cells.depth = std::min(p.shape.cells.depth, share < kCoarsest ? kCoarsestDepth : kCoarseDepth);
      p.shape.cells.tolerance = std::max(p.shape.cells.tolerance, kCoarseTolerance);
    });
  }
  GrowerTraits traits() const override { return {.stands_on_rock = false}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    return SizeEstimate{.triangles = params.native ? 0 : estimate_triangles(params.shape), .blocks = 1};
  }
  Result<Model> grow_alone(Seed seed) const override { return build_rock(params, seed); }
};

}  // namespace

Kind<Organism> rock_kind() { return make_grower<RockGrower>("rock", "A rock: blobs, weathered"); }

}  // namespace frond
