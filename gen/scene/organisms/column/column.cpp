#include "organisms/column/column.h"

#include "geometry/crease.h"
#include "masonry/block.h"
#include "organisms/kinds.h"

namespace frond {

Model build_column_model(const ColumnParams& params) {
  constexpr double kSharp = radians(32.0);  // edges between faces that meet at more stay sharp
  Model model;
  model.hull = column_surface(params.shape);
  Material stone{Matter::limestone, params.stone, toned(params.stone, 0.55, 0.03)};
  stone.scale = 0.25, stone.moss = params.weathering;
  model.solids.place(model.solids.add_shape({creased(model.hull, kSharp), stone}));
  return model;
}

void describe(Properties& v, ColumnParams& c) {
  ColumnShape& s = c.shape;
  v.number("height", s.height, metres(0.2, 30), "Height with base and capital");
  v.number("radius", s.radius, metres(0.02, 3), "Radius of the shaft at its foot");
  v.number("taper", s.taper, {.min = 0.4, .max = 1},
           "Radius at the top of the shaft, as a share of that at its foot");
  v.number("entasis", s.entasis, {.min = 0, .max = 0.2},
           "How much the shaft swells in the middle, as a share of the radius");
  v.integer("flutes", s.flutes, {.min = 0, .max = 48},
            "Number of hollows round the shaft; 0 leaves it plain");
  v.number("flute_depth", s.flute_depth, kShare, "Depth of a flute, as a share of a half circle");
  v.number("broken", s.broken, {.min = 0, .max = 0.95}, "Share of its height that has broken off");
  v.color("stone", c.stone, "Colour of the limestone");
  v.number("weathering", c.weathering, kShare, "How much soot, damp and moss there is");
  v.aspect(Aspect::look, "stone", "weathering");
}

namespace {

class ColumnGrower final : public Described<ColumnParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"height",      "radius", "taper", "entasis",   "flutes",
                                                  "flute_depth", "broken", "stone", "weathering"};

  Review review() const override { return {}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kBroken = 23e3, kWhole = 39e3;
    return SizeEstimate{.triangles = params.shape.broken > 0 ? kBroken : kWhole};
  }
  Result<Model> grow_alone(Seed) const override { return build_column_model(params); }
};

}  // namespace

Kind<Organism> column_kind() {
  return make_grower<ColumnGrower>("column", "A column of stone, whole or broken");
}

}  // namespace frond
